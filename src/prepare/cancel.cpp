// SPDX-License-Identifier: MIT
// Each triangle takes the first one left that faces the other way.
#include "prepare/cancel.h"

#include "mesh/same_corners.h"

namespace kdm {
namespace {

// Pairs share three edges: either one of them has more sides, or each triangle is beyond all sides
// of the other.
std::vector<Index> candidates(std::size_t triangles, const Topology& topology) {
  std::vector<char> crowded(triangles, 0);
  for (const Index side : topology.crowded) crowded[side / 3] = 1;
  std::vector<Index> found;
  for (Index t = 0; t < triangles; ++t) {
    const Index* twin = &topology.twin[3 * std::size_t{t}];
    const bool pillow = twin[0] / 3 == twin[1] / 3 && twin[1] / 3 == twin[2] / 3;
    if (crowded[t] != 0 || pillow) found.push_back(t);
  }
  return found;
}

}  // namespace

std::vector<char> find_opposite_pairs(std::span<const Triangle> triangles, Index points,
                                      const Topology& topology) {
  const std::vector<Index> numbers = candidates(triangles.size(), topology);
  std::vector<Triangle> corners;
  for (const Index t : numbers) corners.push_back(triangles[t]);
  std::vector<char> cancelled(triangles.size(), 0);
  const auto flag = [&](const SortedCorners& c) -> char& { return cancelled[numbers[c.triangle]]; };
  for_each_corner_set(corners, points, [&](std::span<const SortedCorners> group) {
    for (std::size_t a = 0; a < group.size(); ++a) {
      for (std::size_t b = a + 1; b < group.size() && flag(group[a]) == 0; ++b) {
        if (flag(group[b]) != 0 || group[a].turned == group[b].turned) continue;
        flag(group[a]) = flag(group[b]) = 1;
      }
    }
  });
  return cancelled;
}

}  // namespace kdm
