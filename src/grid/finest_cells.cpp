// SPDX-License-Identifier: MIT
#include "grid/finest_cells.h"

#include <algorithm>

#include "geometry/assert.h"

namespace kdm {

FinestCells::FinestCells(int depth) : depth_(depth) {
  KDM_ASSERT(depth >= 1 && depth <= kMostDepth, "the depth is one of which a bit a cell is kept");
  for (int axis = 0; axis < 3; ++axis) {
    const int bits = halvings(axis);
    spread_[axis].resize(std::size_t{1} << bits);
    for (std::uint32_t place = 0; place < spread_[axis].size(); ++place) {
      std::uint32_t code = 0;
      for (int i = 0; i < bits; ++i) {
        code |= (place >> (bits - 1 - i) & 1u) << (depth - 1 - (3 * i + axis));
      }
      spread_[axis][place] = code;
    }
  }
  words_.assign(((std::size_t{1} << depth) + 63) / 64, 0);
}

bool FinestCells::any_within(std::uint32_t code, int depth) const {
  const std::size_t cells = std::size_t{1} << (depth_ - depth);
  const std::size_t first = code & ~(cells - 1);
  if (cells < 64) {
    const std::uint64_t mask = (std::uint64_t{1} << cells) - 1;
    return (words_[first >> 6] >> (first & 63) & mask) != 0;
  }
  const auto begin = words_.begin() + static_cast<std::ptrdiff_t>(first >> 6);
  return std::any_of(begin, begin + static_cast<std::ptrdiff_t>(cells >> 6),
                     [](std::uint64_t word) { return word != 0; });
}

void FinestCells::count() {
  rank_.clear();
  rank_.reserve(words_.size());
  size_ = 0;
  for (const std::uint64_t word : words_) {
    rank_.push_back(size_);
    size_ += static_cast<Index>(std::popcount(word));
  }
}

}  // namespace kdm
