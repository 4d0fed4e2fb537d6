// SPDX-License-Identifier: MIT
// Goes over the set in ascending order. What a cell's code has in common with the one before says
// which of the cells round it are split already.
#include "grid/finest_tree.h"

#include <utility>

#include "mesh/sort.h"

namespace kdm {
namespace {

// Returns the depth of the first cell round a cell of the set that is not round the one before.
int first_new_depth(std::uint32_t code, std::uint32_t before, int depth) {
  return depth - static_cast<int>(std::bit_width(code ^ before)) + 1;
}

}  // namespace

FinestTree::FinestTree(FinestCells cells, std::vector<EmptySplit> empty_splits, GridData& grid)
    : cells_(std::move(cells)) {
  insert_empty_splits(std::move(empty_splits));
  cells_.count();
  number_splits();
  write_cells(grid);
}

// An empty split stands in the set as the first cell within it. Of several round each other, the
// innermost does.
void FinestTree::insert_empty_splits(std::vector<EmptySplit> empty_splits) {
  sort_by(empty_splits, [](const EmptySplit& a, const EmptySplit& b) { return a.depth > b.depth; });
  for (const EmptySplit& split : empty_splits) {
    if (cells_.any_within(split.code, split.depth)) continue;
    cells_.insert(split.code);
    empty_splits_.push_back(split);
  }
  sort_by(empty_splits_, [](const EmptySplit& a, const EmptySplit& b) { return a.code < b.code; });
}

// Returns how many cells are split round a cell of the set: those above this depth.
int FinestTree::splits_round(std::uint32_t code, std::size_t& next_empty) const {
  if (next_empty == empty_splits_.size() || empty_splits_[next_empty].code != code) {
    return cells_.depth();
  }
  return empty_splits_[next_empty++].depth + 1;
}

void FinestTree::number_splits() {
  first_split_.reserve(cells_.size());
  std::size_t next_empty = 0;
  std::uint32_t before = 0;
  cells_.for_each([&](std::uint32_t code) {
    const int first = first_split_.empty() ? 0 : first_new_depth(code, before, cells_.depth());
    first_split_.push_back(splits_ - static_cast<SplitId>(first));
    splits_ += static_cast<SplitId>(splits_round(code, next_empty) - first);
    before = code;
  });
}

void FinestTree::write_cells(GridData& grid) {
  const int depth = cells_.depth();
  grid.cells.assign(2 * std::size_t{splits_} + 1, Cell());
  axis_.resize(splits_);
  leaf_.reserve(cells_.size());
  std::array<CellId, FinestCells::kMostDepth + 1> cell{};       // round the cell at hand, by depth
  std::array<LatticePoint, FinestCells::kMostDepth + 1> low{};  // their lowest corners
  std::size_t next_empty = 0;
  std::uint32_t before = 0;
  cells_.for_each([&](std::uint32_t code) {
    const auto number = static_cast<Index>(leaf_.size());
    const int first = number == 0 ? 0 : first_new_depth(code, before, depth);
    // The last split that both are within leads into its upper half now.
    const auto go_down = [&](int d, SplitId split) {
      const bool above = (code >> (depth - 1 - d) & 1u) != 0;
      cell[d + 1] = 2 * split + (above ? 2 : 1);
      low[d + 1] = low[d];
      if (above) low[d + 1][d % 3] += kLatticeSize >> (d / 3 + 1);
    };
    if (first > 0) go_down(first - 1, grid.cells[cell[first - 1]].split());
    const int end = splits_round(code, next_empty);
    for (int d = first; d < end; ++d) {
      const int axis = d % 3;
      const SplitId split = first_split_[number] + static_cast<SplitId>(d);
      grid.cells[cell[d]] = Cell(2 * split + 1, axis, low[d][axis] + (kLatticeSize >> (d / 3 + 1)));
      axis_[split] = static_cast<unsigned char>(axis);
      go_down(d, split);
    }
    leaf_.push_back(end == depth ? cell[depth] : kNone);
    before = code;
  });
}

}  // namespace kdm
