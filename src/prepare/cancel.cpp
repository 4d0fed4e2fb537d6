// SPDX-License-Identifier: MIT
// Pairs each triangle with the first one over its points that is left and faces the other way.
#include "prepare/cancel.h"

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

Marks find_opposite_pairs(std::span<const Triangle> triangles, Index points) {
  Marks paired(triangles.size());
  for_each_corner_set(triangles, points, [&](std::span<const SortedCorners> group) {
    for (std::size_t a = 0; a < group.size(); ++a) {
      for (std::size_t b = a + 1; b < group.size() && !paired.test(group[a].triangle); ++b) {
        if (paired.test(group[b].triangle) || group[a].turned == group[b].turned) continue;
        paired.set(group[a].triangle);
        paired.set(group[b].triangle);
      }
    }
  });
  return paired;
}

Marks find_opposite_pairs(std::span<const Triangle> triangles, Index points,
                          const Topology& topology) {
  const std::vector<TriangleId> candidates = find_candidates(triangles.size(), topology);
  std::vector<Triangle> corners;
  for (const TriangleId t : candidates) corners.push_back(triangles[t]);
  const Marks found = find_opposite_pairs(corners, points);
  Marks paired(triangles.size());
  for (std::size_t i = 0; i < candidates.size(); ++i) paired.set(candidates[i], found.test(i));
  return paired;
}

}  // namespace kdm
