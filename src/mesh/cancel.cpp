// SPDX-License-Identifier: MIT
// Each triangle takes the first one left that faces the other way.
#include "mesh/cancel.h"

#include "mesh/same_corners.h"

namespace kdm {

std::vector<char> find_opposite_pairs(std::span<const Triangle> triangles, Index points) {
  std::vector<char> cancelled(triangles.size(), 0);
  for_each_corner_set(triangles, points, [&](std::span<const SortedCorners> group) {
    for (std::size_t a = 0; a < group.size(); ++a) {
      for (std::size_t b = a + 1; b < group.size() && cancelled[group[a].triangle] == 0; ++b) {
        if (cancelled[group[b].triangle] != 0 || group[a].turned == group[b].turned) continue;
        cancelled[group[a].triangle] = cancelled[group[b].triangle] = 1;
      }
    }
  });
  return cancelled;
}

}  // namespace kdm
