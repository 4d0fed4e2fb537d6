// SPDX-License-Identifier: MIT
#include "split/cell_crossings.h"

namespace kdm {

void CellCrossings::collect(const CellView& cell) {
  all.clear();
  around_face = {};
  kept = 0;
  has_gaps = false;
  has_touches = false;
  for (int axis = 0; axis < 3; ++axis) {
    for (int ends = 0; ends < 4; ++ends) {
      const int high_next = ends & 1;
      const int high_previous = ends >> 1;
      const int number = cell_edge(axis, high_next != 0, high_previous != 0);
      const EdgeRange edge = cell.edges[number];
      around_face[next_axis(axis)][high_next] += edge.end - edge.begin;
      around_face[previous_axis(axis)][high_previous] += edge.end - edge.begin;
      for (Index i = edge.begin; i < edge.end; ++i) {
        const ClassifiedCrossing& crossing = cell.crossings[i];
        const CrossingRole role = crossing.role();
        all.push_back({crossing.position(), crossing.triangle(), number,
                       role == CrossingRole::kBounds,
                       role == CrossingRole::kInner || role == CrossingRole::kGap});
        if (crossing.kept()) ++kept;
        has_gaps = has_gaps || role == CrossingRole::kGap;
        has_touches = has_touches || role == CrossingRole::kTouching;
      }
    }
  }
}

Vec3 crossing_point(const CellCrossing& crossing, const LatticeBox& box) {
  const int axis = crossing.edge / 4;
  const int u = next_axis(axis);
  const int v = previous_axis(axis);
  Vec3 point;
  point[axis] = real_position(crossing.position);
  point[u] = (crossing.edge & 1) != 0 ? box.hi[u] : box.lo[u];
  point[v] = (crossing.edge & 2) != 0 ? box.hi[v] : box.lo[v];
  return point;
}

bool edge_bounds_face(int edge, int axis, bool high) {
  const int along = edge / 4;
  if (along == axis) return false;
  return ((next_axis(along) == axis ? edge & 1 : edge & 2) != 0) == high;
}

}  // namespace kdm
