// SPDX-License-Identifier: MIT
#include "prepare/two_sided.h"

#include <cmath>

#include "mesh/measure.h"
#include "prepare/cancel.h"

namespace kdm {
namespace {

// What of a part is in pairs, and the rest of it.
struct PairedPart {
  Measure pairs;
  Measure rest;

  // Of a solid with walls inside, the rest bounds the solid.
  bool is_mostly_rest() const { return rest.area > pairs.area; }
  bool has_two_sides() const {
    // A box that is a thousand times as long as it is thick encloses more than this.
    constexpr double kNothing = 1e-4;
    return !is_mostly_rest() &&
           std::abs(rest.volume) <= kNothing * rest.area * std::sqrt(rest.area);
  }
};

}  // namespace

Marks find_two_sided_parts(std::span<const Triangle> triangles, const std::vector<Vec3>& points,
                           const Marks& paired, DisjointSets& parts, Index fewest) {
  Marks two_sided(triangles.size());
  if (!paired.any()) return two_sided;
  // Both by the triangle that stands for the part. Most parts have no pairs: they are not measured.
  std::vector<Index> in_pairs(triangles.size(), 0);
  std::vector<Index> number(triangles.size(), kNone);
  for (TriangleId t = 0; t < triangles.size(); ++t) {
    if (paired.test(t)) ++in_pairs[parts.find(t)];
  }
  std::vector<PairedPart> found;
  const auto add = [&](TriangleId t, Measure& measure) {
    const Triangle& corners = triangles[t];
    measure.add(points[corners[0]], points[corners[1]], points[corners[2]]);
  };
  for (TriangleId t = 0; t < triangles.size(); ++t) {
    if (!paired.test(t)) continue;
    const TriangleId first = parts.find(t);
    if (in_pairs[first] < fewest) continue;
    Index& part = number[first];
    if (part == kNone) {
      part = static_cast<Index>(found.size());
      found.emplace_back();
    }
    add(t, found[part].pairs);
  }
  // As soon as the rest of a part is the larger one, the part is known to be a solid.
  Marks begun(found.size());
  for (TriangleId t = 0; t < triangles.size(); ++t) {
    const Index part = number[parts.find(t)];
    if (part == kNone || found[part].is_mostly_rest()) continue;
    if (!begun.test_and_set(part)) found[part].rest.centre = points[triangles[t][0]];
    if (!paired.test(t)) add(t, found[part].rest);
  }
  for (TriangleId t = 0; t < triangles.size(); ++t) {
    const Index part = number[parts.find(t)];
    two_sided.set(t, part != kNone && found[part].has_two_sides());
  }
  return two_sided;
}

bool some_part_has_two_sides(std::span<const Triangle> triangles, const std::vector<Vec3>& points,
                             const Topology& topology) {
  const auto count = static_cast<Index>(points.size());
  const Marks paired = find_opposite_pairs(triangles, count, topology);
  if (!paired.any()) return false;
  DisjointSets parts = join_at_edges(triangles, count, topology);
  constexpr Index kFewest = 8;
  return find_two_sided_parts(triangles, points, paired, parts, kFewest).any();
}

}  // namespace kdm
