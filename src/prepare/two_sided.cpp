// SPDX-License-Identifier: MIT
#include "prepare/two_sided.h"

#include <cmath>

#include "mesh/edge_sides.h"
#include "mesh/measure.h"
#include "prepare/cancel.h"

namespace kdm {
namespace {

// What of a part is in pairs, and the rest of it.
struct PairedPart {
  Index paired = 0;
  Measure pairs;
  Measure rest;

  bool has_two_sides() const {
    // Of a solid with walls inside, the rest bounds the solid. A box that is a thousand times as
    // long as it is thick encloses more than this.
    constexpr double kNothing = 1e-4;
    return paired > 0 && rest.area <= pairs.area &&
           std::abs(rest.volume) <= kNothing * rest.area * std::sqrt(rest.area);
  }
};

}  // namespace

Marks find_two_sided_parts(std::span<const Triangle> triangles, const std::vector<Vec3>& points,
                           const Marks& paired, DisjointSets& parts, Index fewest) {
  std::vector<PairedPart> found(triangles.size());  // by the triangle that stands for the part
  for (TriangleId t = 0; t < triangles.size(); ++t) {
    const Triangle& corners = triangles[t];
    const TriangleId first = parts.find(t);
    PairedPart& part = found[first];
    part.paired += paired.test(t) ? 1 : 0;
    Measure& measure = paired.test(t) ? part.pairs : part.rest;
    measure.centre = points[triangles[first][0]];
    measure.add(points[corners[0]], points[corners[1]], points[corners[2]]);
  }
  Marks two_sided(triangles.size());
  for (TriangleId t = 0; t < triangles.size(); ++t) {
    const PairedPart& part = found[parts.find(t)];
    two_sided.set(t, part.paired >= fewest && part.has_two_sides());
  }
  return two_sided;
}

bool some_part_has_two_sides(std::span<const Triangle> triangles, const std::vector<Vec3>& points,
                             const Topology& topology) {
  const auto count = static_cast<Index>(points.size());
  const Marks paired = find_opposite_pairs(triangles, count, topology);
  if (!paired.any()) return false;
  DisjointSets parts(triangles.size());
  EdgeSides(triangles, count).for_each_edge([&](PointId, std::span<const EdgeSide> edge) {
    for (const EdgeSide& s : edge) parts.join(triangle_of(edge[0].side), triangle_of(s.side));
  });
  constexpr Index kFewest = 8;
  return find_two_sided_parts(triangles, points, paired, parts, kFewest).any();
}

}  // namespace kdm
