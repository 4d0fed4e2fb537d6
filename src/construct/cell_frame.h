// SPDX-License-Identifier: MIT
// What a cell hands down to its halves during construction.
#pragma once

#include "construct/cell_border.h"
#include "grid/grid_data.h"
#include "split/split_rules.h"
#include "split/triangle_lists.h"

namespace kdm {

/// A cell that may be split.
struct CellFrame : CellBorder {
  CellId cell = 0;
  int depth = 0;
  LatticeBox box;
  ListRange triangles;          ///< that may reach the cell
  bool several_solids = false;  ///< have triangles in the list
  RuleRange rule;               ///< of the split rule
  double done_before = 0;       ///< fraction of the construction before this cell
  double done_after = 1;        ///< fraction of it after this cell
};

/// The two parts of a split cell.
struct Halves {
  CellFrame below;
  CellFrame above;
};

/// Sets the members of both halves that follow from the split alone. Both must be copies of the
/// cell's frame.
void divide_box(const CellFrame& frame, const Split& split, CellId first_child, Halves& halves);

/// Shares the cell's part of the progress by the triangles in its halves.
void divide_progress(const CellFrame& frame, Halves& halves);

}  // namespace kdm
