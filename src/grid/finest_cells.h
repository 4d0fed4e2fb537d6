// SPDX-License-Identifier: MIT
// The cells of one depth in a grid whose splits halve cells across x, y and z in turn: their
// numbering, and a set of some of them.
//
// Each halving adds a bit to a cell's code, 0 for the half below, that of the root's split first.
// So codes ascend in the order in which a recursion comes to the cells (a Morton order), and the
// first bits of a code are those of a larger cell round it.
#pragma once

#include <bit>
#include <vector>

#include "geometry/lattice.h"
#include "mesh/numbers.h"

namespace kdm {

/// A set of cells at the greatest depth. A cell is known by its place, how many such cells lie
/// below it along each axis, or by its code, a number of `depth` bits.
class FinestCells {
 public:
  /// One bit is kept for each cell of this depth, in the set or not: 16 MB.
  static constexpr int kMostDepth = 27;

  /// Makes the empty set of cells of a depth from 1 to kMostDepth.
  explicit FinestCells(int depth);

  int depth() const { return depth_; }
  /// Returns how often the root is halved across an axis before a depth; across that axis, cells of
  /// this depth are `1 << kLatticeBits - halvings` wide.
  static constexpr int halvings(int axis, int depth) { return (depth + 2 - axis) / 3; }
  int halvings(int axis) const { return halvings(axis, depth_); }
  /// Returns the place, along an axis, of the cell above a lattice plane.
  std::int32_t place(int axis, std::int32_t plane) const {
    return plane >> (kLatticeBits - halvings(axis));
  }
  /// Returns the lattice plane at the low side of a place along an axis.
  std::int32_t plane(int axis, std::int32_t place) const {
    return place << (kLatticeBits - halvings(axis));
  }
  /// Returns the depth of the cells that the plane below a place splits. The place is not 0.
  int depth_of_plane(int axis, std::int32_t place) const {
    return 3 * (halvings(axis) - 1 - std::countr_zero(static_cast<std::uint32_t>(place))) + axis;
  }
  std::uint32_t code(const LatticePoint& place) const {
    return spread_[0][place[0]] | spread_[1][place[1]] | spread_[2][place[2]];
  }

  void insert(std::uint32_t code) { words_[code >> 6] |= std::uint64_t{1} << (code & 63); }
  /// Tells whether one of the cells is in the set whose codes begin as this one does: with the bits
  /// of the cell round them at a depth.
  bool any_within(std::uint32_t code, int depth) const;

  /// Counts the cells; none may be inserted afterwards.
  void count();
  /// Returns the number of cells in the set. They must have been counted.
  Index size() const { return size_; }
  /// Returns how many cells of the set have lower codes. They must have been counted.
  Index rank(std::uint32_t code) const {
    const std::uint64_t below = words_[code >> 6] & ((std::uint64_t{1} << (code & 63)) - 1);
    return rank_[code >> 6] + static_cast<Index>(std::popcount(below));
  }
  /// Calls `visit(code)` for every cell of the set, in ascending order.
  template <typename Visit>
  void for_each(const Visit& visit) const {
    for (std::size_t w = 0; w < words_.size(); ++w) {
      for (std::uint64_t word = words_[w]; word != 0; word &= word - 1) {
        visit(static_cast<std::uint32_t>(w << 6 | static_cast<unsigned>(std::countr_zero(word))));
      }
    }
  }

 private:
  int depth_;
  std::array<std::vector<std::uint32_t>, 3> spread_;  // per axis and place the bits of the code
  std::vector<std::uint64_t> words_;                  // a bit for each code
  std::vector<Index> rank_;                           // per word: cells before it
  Index size_ = 0;
};

}  // namespace kdm
