// SPDX-License-Identifier: MIT
// Visits every splitting edge of a grid, with its place and its hits.
#pragma once

#include <span>
#include <vector>

#include "grid/grid_data.h"

namespace kdm {

/// Which of the four edges of a splitting face it is.
struct EdgePlace {
  EdgeId number;  ///< 4k + i for split k
  int i;          ///< 0 to 3 round the splitting face: bottom, right, top, left
  int axis;       ///< the edge runs along it
};

/// One of the four edges of a splitting face. Refers to the grid and to its boxes.
struct SplittingEdge : EdgePlace {
  CellId cell;            ///< the cell that is split
  const Cell& split;      ///< what that cell holds: axis and value of the splitting plane
  const LatticeBox& box;  ///< of that cell
  HitRange hits;

  /// Returns the end with the lower coordinate along `axis`.
  LatticePoint low() const {
    return corner_on_plane(box, split.axis(), split.value(), i == 1, i == 2);
  }
  /// Returns the end with the higher coordinate along `axis`.
  LatticePoint high() const {
    return corner_on_plane(box, split.axis(), split.value(), i != 3, i != 0);
  }
};

/// Finds for each split the cell that it divides; kNone for splits that were removed.
inline std::vector<CellId> cells_of_splits(const GridData& grid) {
  std::vector<CellId> cell_of(grid.splits(), kNone);
  for (CellId c = 0; c < grid.cells.size(); ++c) {
    if (!grid.cells[c].leaf()) cell_of[grid.cells[c].split()] = c;
  }
  return cell_of;
}

/// Calls `visit(const SplittingEdge&)` for every splitting edge, with or without hits, in the order
/// of their numbers, which is the order of the hits as well. `boxes` come from `cell_boxes`. The
/// edges of splits that were removed are left out. Takes time linear in the number of cells.
template <typename Visit>
void for_each_splitting_edge(const GridData& grid, std::span<const LatticeBox> boxes,
                             Visit&& visit) {
  const std::vector<CellId> cell_of = cells_of_splits(grid);
  for (SplitId k = 0; k < grid.splits(); ++k) {
    const CellId cell = cell_of[k];
    if (cell == kNone) continue;
    const Cell& split = grid.cells[cell];
    for (int i = 0; i < 4; ++i) {
      visit(SplittingEdge{{edge_of_split(k, i), i, axis_of_edge(split.axis(), i)},
                          cell,
                          split,
                          boxes[cell],
                          grid.edge_hits(k, i)});
    }
  }
}

}  // namespace kdm
