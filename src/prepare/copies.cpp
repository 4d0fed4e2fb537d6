// SPDX-License-Identifier: MIT
#include "prepare/copies.h"

#include <algorithm>
#include <vector>

#include "mesh/same_corners.h"
#include "prepare/twins.h"

namespace kdm {

Marks find_copies(std::span<const Triangle> triangles, Index points, const Topology& topology,
                  bool two_cancel) {
  Marks further(triangles.size());
  if (topology.non_manifold_edges == 0) return further;
  // How often each triangle is there; 0: once, or both ways.
  std::vector<Index> times(triangles.size(), 0);
  const std::vector<TriangleId> candidates = find_possible_twins(topology);
  std::vector<Triangle> corners;
  for (const TriangleId t : candidates) corners.push_back(triangles[t]);
  for_each_corner_set(corners, points, [&](std::span<const SortedCorners> group) {
    const bool one_way = std::all_of(group.begin(), group.end(), [&](const SortedCorners& c) {
      return c.turned == group[0].turned;
    });
    for (const SortedCorners& c : group) {
      if (one_way) times[candidates[c.triangle]] = static_cast<Index>(group.size());
      if (&c != &group[0]) further.set(candidates[c.triangle]);
    }
  });
  if (!further.any()) return further;
  DisjointSets parts = join_at_edges(triangles, points, topology);
  Marks is_mixed(triangles.size());  // per part, by the triangle that stands for it
  for (TriangleId t = 0; t < triangles.size(); ++t) {
    const Index part = parts.find(t);
    if (times[t] < 2 || times[t] != times[part]) is_mixed.set(part);
  }
  for (TriangleId t = 0; t < triangles.size(); ++t) {
    if (is_mixed.test(parts.find(t))) {
      further.clear(t);
    } else if (two_cancel && times[t] % 2 == 0) {
      further.set(t);
    }
  }
  return further;
}

}  // namespace kdm
