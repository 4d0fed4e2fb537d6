// SPDX-License-Identifier: MIT
#include "split/cell_states.h"

namespace kdm {
namespace {

// Tells whether a triangle reaches out of its cell across the axis.
bool reaches_out(const Outcodes& corners, int axis) {
  const unsigned all = corners[0] | corners[1] | corners[2];
  return (all >> 2 * axis & 3u) != 0;
}

}  // namespace

bool lies_before(const LatticeTriangle& t, const LatticePoint& p) {
  const std::array<std::int64_t, 3> normal = area_vector(t);
  std::int64_t height = 0;
  for (int i = 0; i < 3; ++i) height += normal[i] * (p[i] - t[0][i]);
  for (int i = 0; i < 3 && height == 0; ++i) height = normal[i];  // grid points are shifted upwards
  return height > 0;
}

void CellStates::start(const CellTriangles& cell, int state) {
  cell_ = &cell;
  state_ = state;
  line_members_.list(cell);
  find_first_crossings();
}

// Finds the crossings on the cell's lowest edge along axis 0, on which all ways begin.
void CellStates::find_first_crossings() {
  first_crossings_.clear();
  const LatticePoint& low = cell_->cell().lo;
  line_members_.for_each(0, low, [&](MemberId m) {
    const LatticeTriangle& t = cell_->corners(m);
    const int normal = line_crosses(t, 0, low[1], low[2]);
    if (normal == 0) return;
    const std::int32_t plane = floor_of(crossing_position(t, 0, low[1], low[2]));
    if (plane >= low[0]) first_crossings_.push_back({plane, cell_->triangle(m), normal > 0});
  });
}

// Follows three grid lines from the cell's lowest corner.
int CellStates::at(const LatticePoint& point) const {
  LatticePoint at = cell_->cell().lo;
  int state = state_;
  for (const FirstCrossing& crossing : first_crossings_) {
    if (crossing.plane >= point[0]) continue;
    state = model_.state_after(state, crossing.triangle, crossing.leaving);
  }
  at[0] = point[0];
  for (int axis = 1; axis < 3; ++axis) {
    state = follow(axis, at, point[axis], state);
    at[axis] = point[axis];
  }
  return state;
}

// Follows a grid line upwards from a point in the cell that has the given state, and returns the
// state at the end.
int CellStates::follow(int axis, const LatticePoint& from, std::int32_t to, int state) const {
  const int u = next_axis(axis);
  const int v = previous_axis(axis);
  line_members_.for_each(axis, from, [&](MemberId m) {
    const LatticeBox& bounds = cell_->bounds(m);
    if (bounds.lo[axis] > to || bounds.lo[u] > from[u] || bounds.hi[u] < from[u] ||
        bounds.lo[v] > from[v] || bounds.hi[v] < from[v]) {
      return;
    }
    const LatticeTriangle& t = cell_->corners(m);
    const int normal = line_crosses(t, axis, from[u], from[v]);
    if (normal == 0) return;
    // Of a triangle that lies between the two ends the crossing need not be found.
    const bool between = bounds.lo[axis] > from[axis] && bounds.hi[axis] < to &&
                         !reaches_out(cell_->outcodes(m), axis);
    if (!between) {
      const std::int32_t plane = floor_of(crossing_position(t, axis, from[u], from[v]));
      if (plane < from[axis] || plane >= to) return;
    }
    state = model_.state_after(state, cell_->triangle(m), normal > 0);
  });
  return state;
}

}  // namespace kdm
