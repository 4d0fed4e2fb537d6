// SPDX-License-Identifier: MIT
// Finds the leaves that a box meets by a walk in the cell tree.
#pragma once

#include <array>
#include <vector>

#include "extract/dual/grid_view.h"

namespace kdm {

/// Finds the leaves that a box meets, starting from a leaf near it.
class LeafTree {
 public:
  explicit LeafTree(const GridView& view);

  /// Calls `visit(leaf)` once for each leaf whose closed cell meets the closed box from `lo` to
  /// `hi` (lattice units). `near` is any leaf; the search is short if the box lies within or close
  /// to it: it climbs from there to the smallest cell that holds the whole box, and descends.
  template <typename Visit>
  void for_each_leaf(CellId near, const Vec3& lo, const Vec3& hi, const Visit& visit) const;

 private:
  CellId smallest_cell_round(const Vec3& lo, const Vec3& hi, CellId near) const;

  GridView view_;
  std::vector<CellId> parent_;  // per cell; kNone of the root
};

template <typename Visit>
void LeafTree::for_each_leaf(CellId near, const Vec3& lo, const Vec3& hi,
                             const Visit& visit) const {
  std::array<CellId, kMaxDepth + 1> waiting;  // to be descended into
  waiting[0] = smallest_cell_round(lo, hi, near);
  for (std::size_t count = 1; count > 0;) {
    CellId c = waiting[--count];
    while (!view_.grid.cells[c].leaf()) {
      const Cell& cell = view_.grid.cells[c];
      const double value = cell.value();
      const bool meets_above = hi[cell.axis()] >= value;
      if (lo[cell.axis()] <= value) {
        if (meets_above) waiting[count++] = cell.above();
        c = cell.below();
      } else {
        c = cell.above();
      }
    }
    visit(c);
  }
}

}  // namespace kdm
