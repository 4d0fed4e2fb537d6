// SPDX-License-Identifier: MIT
// Looks from each vertex inwards for a wall that faces the other way.
#include "reduce/local_limits.h"

#include <algorithm>
#include <cmath>

#include "geometry/distance.h"
#include "geometry/triangle.h"

namespace kdm {
namespace {

// A thickness is looked for up to this many times the error, and its share for each side is one
// part in as many.
constexpr double kShares = 8;
// Walls face away from each other if their normals enclose more than some 143 degrees: the two
// sides of a sharp edge are no wall.
constexpr double kOpposite = -0.8;
// How many times its distance from the reference a vertex may have.
constexpr double kSlack = 4;
// A line that passes a triangle nearer than this part of the error hits it.
constexpr double kBeside = 0.1;

class ThicknessSearch {
 public:
  ThicknessSearch(const ScaledMesh& mesh, const Reference& surface, double reach)
      : mesh_(mesh),
        surface_(surface),
        reach_(reach),
        vertex_normals_(mesh.positions.size(), Vec3::Zero()),
        triangle_at_(mesh.positions.size(), kNone) {
    face_normals_.reserve(mesh.triangles.size());
    for (Index t = 0; t < mesh.triangles.size(); ++t) {
      const std::array<Vec3, 3> c = mesh.corners(t);
      const Vec3 doubled = doubled_area_vector(c[0], c[1], c[2]);
      face_normals_.push_back(normalized_or_zero(doubled));
      for (const Index v : mesh.triangles[t]) {
        vertex_normals_[v] += doubled;
        triangle_at_[v] = t;
      }
    }
  }

  /// Returns the way from the vertex through the solid to the wall behind it, at most `reach`.
  double at(Index v) const {
    const Vec3& p = mesh_.positions[v];
    const Vec3 inwards = -normalized_or_zero(vertex_normals_[v]);
    SmallBox way;
    way.grow(p);
    way.grow(Vec3(p + reach_ * inwards));
    double thickness = reach_;
    surface_.tree().any_meeting(way, triangle_at_[v], [&](TriangleId t) {
      const double facing = -face_normals_[t].dot(inwards);
      if (facing > kOpposite) return false;
      const std::array<Vec3, 3>& c = surface_.corners(t);
      const double distance = face_normals_[t].dot(p - c[0]) / facing;
      if (!(distance > 0 && distance < thickness)) return false;
      const double beside = kBeside * reach_ / kShares;
      const Vec3 hit = p + distance * inwards;
      if (squared_distance(hit, c[0], c[1], c[2]) <= beside * beside) thickness = distance;
      return false;
    });
    return thickness;
  }

 private:
  const ScaledMesh& mesh_;
  const Reference& surface_;
  double reach_;
  std::vector<Vec3> face_normals_;
  std::vector<Vec3> vertex_normals_;
  std::vector<TriangleId> triangle_at_;  // per vertex: one of its triangles
};

}  // namespace

std::vector<double> local_limits(const ScaledMesh& mesh, const Reference& surface,
                                 const Reference& reference, const std::vector<TriangleId>& near,
                                 double error) {
  std::vector<double> limits(mesh.positions.size(), error);
  const ThicknessSearch search(mesh, surface, kShares * error);
  for (Index v = 0; v < limits.size(); ++v) {
    const double share = search.at(v) / kShares;
    if (share >= error) continue;
    const TriangleId nearest = reference.nearest(mesh.positions[v], error, near[v]);
    if (nearest == kNone) continue;
    const double off = std::sqrt(reference.squared_distance(nearest, mesh.positions[v]));
    limits[v] = std::max(share, std::min(error / kShares, kSlack * off));
  }
  return limits;
}

}  // namespace kdm
