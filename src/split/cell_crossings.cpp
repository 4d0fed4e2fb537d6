// SPDX-License-Identifier: MIT
#include "split/cell_crossings.h"

namespace kdm {
namespace {

// Returns the two sides of a cell that meet in an edge of it, a bit for each.
unsigned sides_of_edge(int edge) {
  const int axis = edge / 4;
  const int next = 2 * next_axis(axis) + ((edge & 1) != 0 ? 1 : 0);
  const int previous = 2 * previous_axis(axis) + ((edge & 2) != 0 ? 1 : 0);
  return 1u << next | 1u << previous;
}

}  // namespace

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

bool CellCrossings::form_one_loop() const {
  for (const auto& [low, high] : around_face) {
    if ((low != 0 && low != 2) || (high != 0 && high != 2)) return false;
  }
  // On a side with two crossings one curve leads from one to the other.
  unsigned reached = 0;  // sides, a bit for each
  std::size_t connected = 0;
  for (;;) {
    std::size_t now_connected = 0;
    for (const CellCrossing& crossing : all) {
      const unsigned sides = sides_of_edge(crossing.edge);
      if (reached != 0 && (reached & sides) == 0) continue;
      reached |= sides;
      ++now_connected;
    }
    if (now_connected == connected) return connected == all.size();
    connected = now_connected;
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
