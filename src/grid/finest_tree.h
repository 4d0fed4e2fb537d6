// SPDX-License-Identifier: MIT
// The cell tree over a set of cells at the greatest depth, made from the cells upwards.
#pragma once

#include <vector>

#include "grid/finest_cells.h"
#include "grid/grid_data.h"

namespace kdm {

/// A cell that is split although neither half is split further or reaches the greatest depth.
struct EmptySplit {
  std::uint32_t code;  ///< of the first of the cells of the greatest depth within it
  int depth;
};

/// The tree in which just those cells are split that hold a cell of a set, or are named as split.
/// Splits are numbered as a recursion does that goes from the root into the half below first. Which
/// number a split or a leaf has follows from the code of a cell, without a search.
class FinestTree {
 public:
  /// Takes the set and what is split besides, and fills the cells of `grid`. Takes time linear in
  /// the splits and in the words of the set.
  FinestTree(FinestCells cells, std::vector<EmptySplit> empty_splits, GridData& grid);

  const FinestCells& cells() const { return cells_; }
  /// Returns the split of the cell at a depth round the cell with this code. There must be one.
  SplitId split(std::uint32_t code, int depth) const {
    const std::uint32_t within = (std::uint32_t{1} << (cells_.depth() - depth)) - 1;
    return first_split_[cells_.rank(code & ~within)] + static_cast<SplitId>(depth);
  }
  /// Returns the axis across which a split halves its cell.
  int axis(SplitId split) const { return axis_[split]; }
  /// Returns the leaf that a cell of the set is, given how many cells of the set come before it.
  CellId leaf(Index rank) const { return leaf_[rank]; }

 private:
  void insert_empty_splits(std::vector<EmptySplit> empty_splits);
  void number_splits();
  void write_cells(GridData& grid);
  int splits_round(std::uint32_t code, std::size_t& next_empty) const;

  FinestCells cells_;
  std::vector<EmptySplit> empty_splits_;  // ascending; their codes are in the set
  SplitId splits_ = 0;
  // Per cell of the set: the number of the first split that is made for it, less its depth. Splits
  // round the cell that were not there before are numbered from there, downwards.
  std::vector<SplitId> first_split_;
  std::vector<CellId> leaf_;         // per cell of the set
  std::vector<unsigned char> axis_;  // per split
};

}  // namespace kdm
