// SPDX-License-Identifier: MIT
#include "prepare/copies.h"

#include <algorithm>
#include <vector>

#include "mesh/disjoint_sets.h"
#include "mesh/edge_sides.h"
#include "mesh/same_corners.h"

namespace kdm {

Marks find_copies(std::span<const Triangle> triangles, Index points, const Topology& topology) {
  Marks further(triangles.size());
  if (topology.non_manifold_edges == 0) return further;
  std::vector<Index> times(triangles.size(), 0);  // how often each triangle is there; 0: both ways
  for_each_corner_set(triangles, points, [&](std::span<const SortedCorners> group) {
    const bool one_way = std::all_of(group.begin(), group.end(), [&](const SortedCorners& c) {
      return c.turned == group[0].turned;
    });
    for (const SortedCorners& c : group) {
      if (one_way) times[c.triangle] = static_cast<Index>(group.size());
      if (&c != &group[0]) further.set(c.triangle);
    }
  });
  if (!further.any()) return further;
  DisjointSets parts(triangles.size());
  EdgeSides(triangles, points).for_each_edge([&](PointId, std::span<const EdgeSide> edge) {
    for (const EdgeSide& s : edge) parts.join(triangle_of(edge[0].side), triangle_of(s.side));
  });
  Marks is_mixed(triangles.size());  // per part, by the triangle that stands for it
  for (TriangleId t = 0; t < triangles.size(); ++t) {
    const Index part = parts.find(t);
    if (times[t] < 2 || times[t] != times[part]) is_mixed.set(part);
  }
  for (TriangleId t = 0; t < triangles.size(); ++t) {
    if (is_mixed.test(parts.find(t))) further.clear(t);
  }
  return further;
}

}  // namespace kdm
