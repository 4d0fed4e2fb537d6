// SPDX-License-Identifier: MIT
// Tests triangles against splitting edges.
#include "construct/crossing_search.h"

namespace kdm {

void CrossingSearch::run(const LatticeBox& box, const Split& split, const TriangleLists& lists) {
  const int u = next_axis(split.axis);
  const int v = previous_axis(split.axis);
  for (std::vector<Crossing>& found : found_) found.clear();
  for (const Index i : lists.straddlers()) {
    const ListEntry& entry = lists.entry(i);
    const TriangleId t = entry.triangle;
    // A triangle reaches an edge only if its bounds reach the side of the cell that has the edge.
    if (entry.lo[v] == box.lo[v]) test(t, u, box.lo[v], split.value, box, found_[0]);
    if (entry.hi[u] == box.hi[u]) test(t, v, split.value, box.hi[u], box, found_[1]);
    if (entry.hi[v] == box.hi[v]) test(t, u, box.hi[v], split.value, box, found_[2]);
    if (entry.lo[u] == box.lo[u]) test(t, v, split.value, box.lo[u], box, found_[3]);
  }
}

// Adds the crossing of a triangle with the grid line along `axis` through (p, q), on the axes after
// it, if there is one within the cell.
void CrossingSearch::test(TriangleId triangle, int axis, std::int32_t p, std::int32_t q,
                          const LatticeBox& box, std::vector<Crossing>& found) const {
  const LatticeTriangle& t = triangles_[triangle];
  const int sign = line_crosses(t, axis, p, q);
  if (sign == 0) return;
  const LinePosition position = crossing_position(t, axis, p, q);
  if (floor_of(position) < box.lo[axis] || floor_of(position) >= box.hi[axis]) return;
  found.push_back({position, triangle, sign > 0});
}

}  // namespace kdm
