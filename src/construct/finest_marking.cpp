// SPDX-License-Identifier: MIT
#include "construct/finest_marking.h"

#include <algorithm>

namespace kdm {

void FinestMarking::add(TriangleId triangle) {
  divide(whole_entry(triangle, triangles_[triangle]), {0, 0, 0});
}

// Of the planes that split the cell round the entry, finds the first one that the entry straddles,
// and divides it there. `cell_low` is the lowest corner of a cell that holds all of the entry.
void FinestMarking::divide(const ListEntry& entry, const LatticePoint& cell_low) {
  // A coordinate at a plane is below it: cell i of those of width w holds i w + 1 to (i + 1) w.
  LatticePoint first;
  LatticePoint last;
  int depth = cells_.depth();
  for (int k = 0; k < 3; ++k) {
    first[k] = std::max(entry.lo[k] - 1, cell_low[k]);
    last[k] = std::max(entry.hi[k] - 1, cell_low[k]);
    const int halvings =
        kLatticeBits -
        static_cast<int>(std::bit_width(static_cast<std::uint32_t>(first[k] ^ last[k])));
    depth = std::min(depth, 3 * halvings + k);
  }
  if (depth == cells_.depth()) {
    LatticePoint place;
    for (int k = 0; k < 3; ++k) place[k] = cells_.place(k, first[k]);
    cells_.insert(cells_.code(place));
    find_crossings(entry, place);
    return;
  }
  const int axis = depth % 3;
  const std::int32_t half = kLatticeSize >> (depth / 3 + 1);
  const std::int32_t value = last[axis] & -half;
  LatticePoint low;  // of the lower half of the cell that is split
  for (int k = 0; k < 3; ++k) {
    low[k] = first[k] & -(kLatticeSize >> FinestCells::halvings(k, depth));
  }
  const DividedEntry parts = divide_entry(triangles_[entry.triangle], entry, axis, value);
  if (parts.meets[0]) divide(parts.part[0], low);
  if (!parts.meets[0] && !parts.meets[1]) {
    LatticePoint place;
    for (int k = 0; k < 3; ++k) place[k] = cells_.place(k, low[k]);
    empty_splits_.push_back({cells_.code(place), depth});
  }
  low[axis] = value;
  if (parts.meets[1]) divide(parts.part[1], low);
}

// Finds the crossings with the three edges of a cell that meet in its lowest corner. What crosses
// an edge of a cell reaches all four cells round it, so each crossing is found once.
void FinestMarking::find_crossings(const ListEntry& entry, const LatticePoint& place) {
  LatticePoint low;
  std::array<bool, 3> reaches{};  // the low side across each axis
  int reached = 0;
  for (int k = 0; k < 3; ++k) {
    low[k] = cells_.plane(k, place[k]);
    reaches[k] = entry.lo[k] == low[k];
    reached += reaches[k] ? 1 : 0;
  }
  if (reached < 2) return;
  const LatticeTriangle& t = triangles_[entry.triangle];
  for (int axis = 0; axis < 3; ++axis) {
    const int u = next_axis(axis);
    const int v = previous_axis(axis);
    if (!reaches[u] || !reaches[v]) continue;
    const int sign = line_crosses(t, axis, low[u], low[v]);
    if (sign == 0) continue;
    const LinePosition position = crossing_position(t, axis, low[u], low[v]);
    if (cells_.place(axis, floor_of(position)) != place[axis]) continue;
    crossings_.push_back({{position, entry.triangle, sign > 0}, lines_.line(axis, place)});
  }
}

}  // namespace kdm
