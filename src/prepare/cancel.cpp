// SPDX-License-Identifier: MIT
// Pairs each triangle with the first one over its points that is left and faces the other way.
#include "prepare/cancel.h"

#include "mesh/same_corners.h"
#include "prepare/twins.h"

namespace kdm {

Marks find_opposite_pairs(std::span<const Triangle> triangles, Index points,
                          const Topology& topology) {
  const std::vector<TriangleId> candidates = find_possible_twins(topology);
  std::vector<Triangle> corners;
  for (const TriangleId t : candidates) corners.push_back(triangles[t]);
  Marks paired(triangles.size());
  for_each_corner_set(corners, points, [&](std::span<const SortedCorners> group) {
    for (std::size_t a = 0; a < group.size(); ++a) {
      const TriangleId first = candidates[group[a].triangle];
      for (std::size_t b = a + 1; b < group.size() && !paired.test(first); ++b) {
        const TriangleId second = candidates[group[b].triangle];
        if (paired.test(second) || group[a].turned == group[b].turned) continue;
        paired.set(first);
        paired.set(second);
      }
    }
  });
  return paired;
}

}  // namespace kdm
