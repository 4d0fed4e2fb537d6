// SPDX-License-Identifier: MIT
// Pairs each triangle with the first one over its points that is left and faces the other way.
#include "prepare/cancel.h"

#include "mesh/disjoint_sets.h"
#include "mesh/edge_sides.h"
#include "mesh/same_corners.h"

namespace kdm {
namespace {

// Finds the triangles that may be in a pair. The two of a pair share three edges: either one of
// the edges has further sides, or all three sides of each triangle have the other one beyond them.
std::vector<TriangleId> find_candidates(std::size_t triangles, const Topology& topology) {
  Marks at_non_manifold_edge(triangles);
  for (const SideId side : topology.non_manifold_sides) at_non_manifold_edge.set(triangle_of(side));
  std::vector<TriangleId> found;
  for (TriangleId t = 0; t < triangles; ++t) {
    const SideId* opposite = &topology.opposite[3 * std::size_t{t}];
    const bool pillow = triangle_of(opposite[0]) == triangle_of(opposite[1]) &&
                        triangle_of(opposite[1]) == triangle_of(opposite[2]);
    if (at_non_manifold_edge.test(t) || pillow) found.push_back(t);
  }
  return found;
}

}  // namespace

Marks find_opposite_pairs(std::span<const Triangle> triangles, Index points,
                          const Topology& topology) {
  const std::vector<TriangleId> candidates = find_candidates(triangles.size(), topology);
  std::vector<Triangle> corners;
  for (const TriangleId t : candidates) corners.push_back(triangles[t]);
  Marks paired(triangles.size());
  const auto number_of = [&](const SortedCorners& c) { return candidates[c.triangle]; };
  for_each_corner_set(corners, points, [&](std::span<const SortedCorners> group) {
    for (std::size_t a = 0; a < group.size(); ++a) {
      for (std::size_t b = a + 1; b < group.size() && !paired.test(number_of(group[a])); ++b) {
        if (paired.test(number_of(group[b])) || group[a].turned == group[b].turned) continue;
        paired.set(number_of(group[a]));
        paired.set(number_of(group[b]));
      }
    }
  });
  return paired;
}

bool some_part_cancels(std::span<const Triangle> triangles, Index points,
                       const Topology& topology) {
  const Marks cancelled = find_opposite_pairs(triangles, points, topology);
  if (!cancelled.any()) return false;
  DisjointSets parts(triangles.size());
  EdgeSides(triangles, points).for_each_edge([&](PointId, std::span<const EdgeSide> edge) {
    for (const EdgeSide& s : edge) parts.join(triangle_of(edge[0].side), triangle_of(s.side));
  });
  Marks something_is_left(triangles.size());
  for (TriangleId t = 0; t < triangles.size(); ++t) {
    if (!cancelled.test(t)) something_is_left.set(parts.find(t));
  }
  constexpr Index kFewest = 8;
  std::vector<Index> size(triangles.size(), 0);
  for (TriangleId t = 0; t < triangles.size(); ++t) {
    const Index part = parts.find(t);
    if (!something_is_left.test(part) && ++size[part] == kFewest) return true;
  }
  return false;
}

}  // namespace kdm
