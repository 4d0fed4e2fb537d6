// SPDX-License-Identifier: MIT
// Divides each triangle among the cells of the greatest depth, and finds its crossings with grid
// lines on the way.
#pragma once

#include <vector>

#include "grid/finest_cells.h"
#include "grid/finest_tree.h"
#include "inside/crossing.h"
#include "split/triangle_lists.h"

namespace kdm {

/// A crossing of a triangle with a grid line, and the line's number (see FinestLines).
struct LineCrossing {
  Crossing crossing;
  Index line;
};

/// The grid lines along each axis at the sides of cells of the greatest depth, numbered.
class FinestLines {
 public:
  explicit FinestLines(const FinestCells& cells) {
    for (int axis = 0; axis < 3; ++axis) {
      bits_[axis] = cells.halvings(axis);
      const int across = cells.halvings(next_axis(axis)) + cells.halvings(previous_axis(axis));
      begin_[axis + 1] = begin_[axis] + (Index{1} << across);
    }
  }

  Index size() const { return begin_[3]; }
  /// Returns the line along an axis through the lowest corner of the cell at a place.
  Index line(int axis, const LatticePoint& place) const {
    const int v = previous_axis(axis);
    return begin_[axis] + (static_cast<Index>(place[next_axis(axis)]) << bits_[v]) +
           static_cast<Index>(place[v]);
  }
  /// Returns the axis along which a line runs.
  int axis(Index line) const { return line < begin_[1] ? 0 : (line < begin_[2] ? 1 : 2); }
  /// Returns the place of a cell of which the line meets the lowest corner: the lowest along it.
  LatticePoint place(Index line) const {
    const int along = axis(line);
    const int v = previous_axis(along);
    LatticePoint place{};
    place[next_axis(along)] = static_cast<std::int32_t>((line - begin_[along]) >> bits_[v]);
    place[v] = static_cast<std::int32_t>((line - begin_[along]) & ((Index{1} << bits_[v]) - 1));
    return place;
  }

 private:
  std::array<int, 3> bits_{};     // of places along each axis
  std::array<Index, 4> begin_{};  // per axis its first line
};

/// Puts the cells into a set whose lists of triangles a recursion from the root would not find
/// empty. A triangle is cut as the lists cut it, at the same planes in the same order, and so comes
/// to the same cells; planes that it does not straddle are passed over at once.
class FinestMarking {
 public:
  /// The arguments must outlive this. Cells are added to `cells`.
  FinestMarking(const std::vector<LatticeTriangle>& triangles, FinestCells& cells,
                std::vector<LineCrossing>& crossings)
      : triangles_(triangles), cells_(cells), lines_(cells), crossings_(crossings) {}

  void add(TriangleId triangle);
  /// Returns the cells that a recursion would split although neither half has a triangle.
  std::vector<EmptySplit> take_empty_splits() { return std::move(empty_splits_); }

 private:
  void divide(const ListEntry& entry, const LatticePoint& cell_low);
  void find_crossings(const ListEntry& entry, const LatticePoint& first);

  const std::vector<LatticeTriangle>& triangles_;
  FinestCells& cells_;
  FinestLines lines_;
  std::vector<LineCrossing>& crossings_;
  std::vector<EmptySplit> empty_splits_;
};

}  // namespace kdm
