// SPDX-License-Identifier: MIT
// Looks points up on the mesh that was reduced.
#include "reduce/carry_over.h"

#include <cmath>

#include "geometry/triangle.h"
#include "mesh/scale.h"
#include "threads/share_work.h"

namespace kdm {
namespace {

// How far from a corner, as a part of the way to the triangle's middle, its normal is looked up.
constexpr double kInside = 0.05;
// Threads share triangles by so many. Each part begins its search anew, so that what is known of
// the triangle before decides the same with any number of threads.
constexpr std::size_t kTrianglesPerPart = 256;

// Returns the barycentric coordinates of the point of the triangle's plane that is nearest to p,
// cut off at 0.
Vec3 weights_at(const std::array<Vec3, 3>& t, const Vec3& p) {
  const Vec3 normal = doubled_area_vector(t[0], t[1], t[2]);
  Vec3 weights;
  for (int i = 0; i < 3; ++i) {
    const Vec3 part = doubled_area_vector(p, t[(i + 1) % 3], t[(i + 2) % 3]);
    weights[i] = std::max(0.0, part.dot(normal));
  }
  const double sum = weights.sum();
  return sum > 0 ? Vec3(weights / sum) : Vec3(Vec3::Constant(1.0 / 3));
}

class Lookup {
 public:
  explicit Lookup(const Carrier& carrier)
      : from_(carrier.mesh), groups_(carrier.groups), surface_(carrier.surface) {}

  /// Returns the triangle nearest to a point of those that face along `normal`; of all if none
  /// does. `group` is that to which it must belong, if there are groups.
  TriangleId nearest(const Vec3& p, const Vec3& normal, Index group) {
    const auto counts = [&](TriangleId t) { return groups_.empty() || groups_[t] == group; };
    const TriangleId facing = surface_.nearest_facing(p, normal, hint_, counts);
    hint_ = facing != kNone ? facing : surface_.nearest_of(p, hint_, counts);
    return hint_;
  }

  std::array<float, 3> normal_at(const Vec3& p, const Vec3& normal, Index group) {
    const TriangleId t = nearest(p, normal, group);
    const Vec3 weights = weights_at(surface_.corners(t), p);
    Vec3 sum = Vec3::Zero();
    for (std::size_t i = 0; i < 3; ++i) {
      const std::array<float, 3>& n = from_.corner_normals[3 * std::size_t{t} + i];
      sum += weights[static_cast<int>(i)] * Vec3(n[0], n[1], n[2]);
    }
    const Eigen::Vector3f unit = normalized_or_zero(sum).cast<float>();
    return {unit[0], unit[1], unit[2]};
  }

 private:
  const ScaledMesh& from_;
  const std::vector<Index>& groups_;
  const Reference& surface_;
  TriangleId hint_ = kNone;
};

}  // namespace

void carry_over(const Carrier& carrier, const std::vector<Index>& groups, int exponent, Mesh& to) {
  const ScaledMesh& from = carrier.mesh;
  const bool sources = !from.source_faces.empty() || !from.source_operands.empty();
  if (!sources && from.corner_normals.empty()) return;
  const std::vector<Vec3> positions = scaled(to.positions, exponent);
  if (!from.source_faces.empty()) to.source_faces.resize(to.triangles.size());
  if (!from.source_operands.empty()) to.source_operands.resize(to.triangles.size());
  if (!from.corner_normals.empty()) to.corner_normals.resize(3 * to.triangles.size());
  const auto look_up = [&](Lookup& lookup, std::size_t i) {
    const Triangle& t = to.triangles[i];
    const Index group = groups.empty() ? kNone : groups[i];
    const std::array<Vec3, 3> c = {positions[t[0]], positions[t[1]], positions[t[2]]};
    const Vec3 normal = doubled_area_vector(c[0], c[1], c[2]);
    const Vec3 middle = (c[0] + c[1] + c[2]) / 3;
    if (sources) {
      const TriangleId source = lookup.nearest(middle, normal, group);
      if (!from.source_faces.empty()) to.source_faces[i] = from.source_faces[source];
      if (!from.source_operands.empty()) to.source_operands[i] = from.source_operands[source];
    }
    if (from.corner_normals.empty()) return;
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const Vec3 inside = c[corner] + kInside * (middle - c[corner]);
      to.corner_normals[3 * i + corner] = lookup.normal_at(inside, normal, group);
    }
  };
  share_parts(to.triangles.size(), kTrianglesPerPart, [&](std::size_t begin, std::size_t end) {
    Lookup lookup(carrier);
    for (std::size_t i = begin; i < end; ++i) look_up(lookup, i);
  });
}

}  // namespace kdm
