// SPDX-License-Identifier: MIT
// Trees that are made from sets of finest cells, against a plain recursion.
#include "grid/finest_tree.h"

#include <gtest/gtest.h>

#include <set>
#include <utility>

#include "support/random.h"

namespace kdm {
namespace {

// The recursion that FinestTree is to agree with: splits a cell if a code in it is in the set, or
// if it is round an empty split or is one.
class PlainTree {
 public:
  PlainTree(int depth, const std::set<std::uint32_t>& codes,
            const std::vector<EmptySplit>& empty_splits)
      : depth_(depth) {
    for (const std::uint32_t code : codes) {
      for (int d = 0; d < depth; ++d) split_.insert({d, code >> (depth - d)});
    }
    for (const EmptySplit& empty : empty_splits) {
      for (int d = 0; d <= empty.depth; ++d) split_.insert({d, empty.code >> (depth - d)});
    }
    cells.push_back(Cell());
    add(0, 0, 0, {});
  }

  std::vector<Cell> cells;
  std::vector<std::pair<int, std::uint32_t>> splits;            // depth and first bits of the code
  std::vector<std::pair<std::uint32_t, CellId>> finest_leaves;  // ascending

 private:
  void add(CellId cell, int depth, std::uint32_t bits, LatticeBox box) {
    if (depth == depth_) finest_leaves.push_back({bits, cell});
    if (depth == depth_ || split_.count({depth, bits}) == 0) return;
    const auto split = static_cast<SplitId>(cells.size() / 2);
    const int axis = depth % 3;
    const std::int32_t value = box.lo[axis] + extent(box, axis) / 2;
    splits.push_back({depth, bits});
    cells[cell] = Cell(2 * split + 1, axis, value);
    cells.resize(cells.size() + 2);
    LatticeBox below = box;
    below.hi[axis] = value;
    add(2 * split + 1, depth + 1, 2 * bits, below);
    box.lo[axis] = value;
    add(2 * split + 2, depth + 1, 2 * bits + 1, box);
  }

  int depth_;
  std::set<std::pair<int, std::uint32_t>> split_;
};

TEST(FinestTree, IsThatOfARecursion) {
  check::Random random(1);
  std::size_t empty_in_all = 0;
  for (int round = 0; round < 300; ++round) {
    const int depth = 1 + static_cast<int>(random.below(12));
    const auto random_code = [&] { return random.below(1u << depth); };
    FinestCells cells(depth);
    std::set<std::uint32_t> codes;
    for (std::uint32_t i = random.below(40); i > 0; --i) {
      codes.insert(random_code());
    }
    for (const std::uint32_t code : codes) cells.insert(code);
    std::vector<EmptySplit> empty_splits;
    for (std::uint32_t i = random.below(6); i > 0; --i) {
      const int at = static_cast<int>(random.below(static_cast<std::uint32_t>(depth)));
      empty_splits.push_back({random_code() >> (depth - at) << (depth - at), at});
    }
    const PlainTree plain(depth, codes, empty_splits);
    GridData grid;
    const FinestTree tree(std::move(cells), empty_splits, grid);
    ASSERT_EQ(grid.cells.size(), plain.cells.size());
    for (std::size_t c = 0; c < grid.cells.size(); ++c) {
      ASSERT_EQ(grid.cells[c].leaf(), plain.cells[c].leaf());
      if (grid.cells[c].leaf()) continue;
      ASSERT_EQ(grid.cells[c].below(), plain.cells[c].below());
      ASSERT_EQ(grid.cells[c].axis(), plain.cells[c].axis());
      ASSERT_EQ(grid.cells[c].value(), plain.cells[c].value());
    }
    for (SplitId s = 0; s < plain.splits.size(); ++s) {
      const auto [at, bits] = plain.splits[s];
      const std::uint32_t within = random.below(1u << (depth - at));
      EXPECT_EQ(tree.split(bits << (depth - at) | within, at), s);
      EXPECT_EQ(tree.axis(s), at % 3);
    }
    for (const auto& [code, leaf] : plain.finest_leaves) {
      if (codes.count(code) == 0) continue;
      EXPECT_EQ(tree.leaf(tree.cells().rank(code)), leaf);
    }
    for (const EmptySplit& empty : empty_splits) {
      const int rest = depth - empty.depth;
      const auto next = codes.lower_bound(empty.code);
      const bool alone = next == codes.end() || *next >> rest != empty.code >> rest;
      empty_in_all += alone ? 1 : 0;
    }
  }
  EXPECT_GT(empty_in_all, 100u);
}

TEST(FinestCells, CodesFollowPlacesAndPlanes) {
  for (const int depth : {1, 2, 3, 11, 12, FinestCells::kMostDepth}) {
    const FinestCells cells(depth);
    check::Random random(static_cast<std::uint32_t>(depth));
    for (int round = 0; round < 100; ++round) {
      LatticePoint point;
      for (int k = 0; k < 3; ++k) point[k] = static_cast<std::int32_t>(random.below(kLatticeSize));
      LatticePoint place;
      for (int k = 0; k < 3; ++k) {
        place[k] = cells.place(k, point[k]);
        EXPECT_LE(cells.plane(k, place[k]), point[k]);
        EXPECT_GT(cells.plane(k, place[k] + 1), point[k]);
      }
      LatticeBox box;
      std::uint32_t code = 0;
      std::array<int, 3> depth_of_low{-1, -1, -1};  // of the split at the low side of the box
      for (int d = 0; d < depth; ++d) {
        const int axis = d % 3;
        const std::int32_t value = box.lo[axis] + extent(box, axis) / 2;
        const bool above = point[axis] >= value;
        (above ? box.lo : box.hi)[axis] = value;
        if (above) depth_of_low[axis] = d;
        code = 2 * code + (above ? 1 : 0);
      }
      EXPECT_EQ(cells.code(place), code);
      for (int k = 0; k < 3; ++k) {
        if (place[k] == 0) continue;
        EXPECT_EQ(cells.depth_of_plane(k, place[k]), depth_of_low[k]);
      }
    }
  }
}

}  // namespace
}  // namespace kdm
