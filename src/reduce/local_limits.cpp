// SPDX-License-Identifier: MIT
// Looks from each vertex inwards and outwards for a wall that faces the other way.
#include "reduce/local_limits.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "geometry/distance.h"
#include "geometry/triangle.h"
#include "mesh/groups.h"
#include "threads/share_work.h"

namespace kdm {
namespace {

// A thickness is looked for up to this many times the error, and its share for each side is one
// part in as many.
constexpr double kShares = 8;
// Walls face away from each other if their normals enclose more than some 143 degrees: the two
// sides of a sharp edge are no wall.
constexpr double kOpposite = -0.8;
// Triangles look the same way if their normals enclose less than some 18 degrees.
constexpr double kSame = 0.95;
// A side of an edge has at least this share of the area that the vertex's triangles have together,
// seen along its normal. Folded slivers have less.
constexpr double kSide = 0.25;
// What is less than this many times the error away is near. There, normals that enclose more than
// some 107 degrees will do, so that tips count.
constexpr double kNarrow = 4;
constexpr double kAcross = -0.3;
// How many times its distance from the reference a vertex may have.
constexpr double kSlack = 4;
// A line that passes a triangle nearer than this part of the error hits it.
constexpr double kBeside = 0.1;
// Threads share vertices by so many.
constexpr std::size_t kVerticesPerPart = 512;

// The walls across from a vertex.
struct Walls {
  double thickness;  // the way through the solid to the wall behind it
  bool narrow;       // whether one is near, behind or before it
};

class WallSearch {
 public:
  WallSearch(const ScaledMesh& mesh, const Reference& surface, double error)
      : mesh_(mesh),
        surface_(surface),
        error_(error),
        vertex_normals_(mesh.positions.size(), Vec3::Zero()),
        triangle_at_(mesh.positions.size(), kNone) {
    face_normals_.reserve(mesh.triangles.size());
    doubled_areas_.reserve(mesh.triangles.size());
    doubled_areas_seen_.reserve(mesh.positions.size());
    for (Index t = 0; t < mesh.triangles.size(); ++t) {
      const std::array<Vec3, 3> c = mesh.corners(t);
      const Vec3 doubled = doubled_area_vector(c[0], c[1], c[2]);
      face_normals_.push_back(normalized_or_zero(doubled));
      doubled_areas_.push_back(doubled.norm());
      for (const Index v : mesh.triangles[t]) {
        vertex_normals_[v] += doubled;
        triangle_at_[v] = t;
      }
    }
    for (Vec3& normal : vertex_normals_) {
      doubled_areas_seen_.push_back(normal.norm());
      normal = normalized_or_zero(normal);
    }
    turned_faces_ = Groups(mesh.positions.size(), [&](const auto& put) {
      for (Index t = 0; t < mesh.triangles.size(); ++t) {
        for (const Index v : mesh.triangles[t]) {
          if (face_normals_[t].dot(vertex_normals_[v]) < -kOpposite) put(v, t);
        }
      }
    });
  }

  /// Finds the walls across from the vertex; a thickness of `kShares` times the error stands for
  /// all above. On a sharp edge looks along the normals of its sides too: a rod has walls behind
  /// these, and none behind the edge.
  Walls at(Index v) const {
    Walls found{kShares * error_, false};
    look(v, vertex_normals_[v], found);
    const std::span<const TriangleId> turned = turned_faces_.of(v);
    for (std::size_t i = 0; i < turned.size(); ++i) {
      const Vec3& normal = face_normals_[turned[i]];
      double area = 0;  // doubled
      bool is_first = true;
      for (std::size_t k = 0; k < turned.size(); ++k) {
        if (face_normals_[turned[k]].dot(normal) <= kSame) continue;
        is_first = is_first && k >= i;
        area += doubled_areas_[turned[k]];
      }
      if (is_first && area >= kSide * doubled_areas_seen_[v]) look(v, normal, found);
    }
    return found;
  }

 private:
  // Looks along one line through the vertex.
  void look(Index v, const Vec3& outwards, Walls& found) const {
    const Vec3& p = mesh_.positions[v];
    SmallBox behind;
    behind.grow(p);
    behind.grow(Vec3(p - kShares * error_ * outwards));
    SmallBox way = behind;
    way.grow(Vec3(p + kNarrow * error_ * outwards));
    surface_.tree().any_meeting(way, triangle_at_[v], [&](TriangleId t) {
      const double facing = face_normals_[t].dot(outwards);
      if (facing > kAcross) return false;
      const std::array<Vec3, 3>& c = surface_.corners(t);
      const double ahead = face_normals_[t].dot(c[0] - p) / facing;
      const bool thins = facing <= kOpposite && ahead < 0 && -ahead < found.thickness &&
                         behind.meets(surface_.tree().box(t)) && !has_corner(t, v);
      const bool narrows = !found.narrow && ahead != 0 && std::abs(ahead) < kNarrow * error_;
      if (!thins && !narrows) return false;
      const double beside = kBeside * error_;
      const Vec3 hit = p + ahead * outwards;
      if (squared_distance(hit, c[0], c[1], c[2]) > beside * beside) return false;
      if (thins) found.thickness = -ahead;
      if (narrows) found.narrow = true;
      return false;
    });
  }

  bool has_corner(TriangleId t, Index v) const {
    const Triangle& corners = mesh_.triangles[t];
    return std::find(corners.begin(), corners.end(), v) != corners.end();
  }

  const ScaledMesh& mesh_;
  const Reference& surface_;
  double error_;
  std::vector<Vec3> face_normals_;
  std::vector<Vec3> vertex_normals_;
  std::vector<double> doubled_areas_;       // per triangle
  std::vector<double> doubled_areas_seen_;  // per vertex: of its triangles, seen along its normal
  std::vector<TriangleId> triangle_at_;     // per vertex: one of its triangles
  Groups turned_faces_;  // per vertex: the triangles there that do not look the way its normal does
};

}  // namespace

LocalLimits local_limits(const ScaledMesh& mesh, const Reference& surface,
                         const Reference& reference, const std::vector<TriangleId>& near,
                         double error) {
  LocalLimits limits{std::vector<double>(mesh.positions.size(), error),
                     Marks(mesh.positions.size())};
  const WallSearch search(mesh, surface, error);
  const auto look = [&](VertexId v) {
    const Walls walls = search.at(v);
    if (walls.narrow) limits.narrow.set(v);
    const double share = walls.thickness / kShares;
    if (share >= error) return;
    const TriangleId nearest = reference.nearest(mesh.positions[v], error, near[v]);
    if (nearest == kNone) return;
    const double off = std::sqrt(reference.squared_distance(nearest, mesh.positions[v]));
    limits.distance[v] = std::max(share, std::min(error / kShares, kSlack * off));
  };
  share_parts(mesh.positions.size(), kVerticesPerPart, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) look(static_cast<VertexId>(v));
  });
  return limits;
}

}  // namespace kdm
