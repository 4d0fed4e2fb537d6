// SPDX-License-Identifier: MIT
// Goes along segments by steps, and marks each cube that it comes to with those that touch it.
#include "reduce/cell_bits.h"

#include <algorithm>
#include <cmath>

namespace kdm {
namespace {

constexpr double kMostCells = 512;

}  // namespace

CellBits::CellBits(const Box& box, double width, const std::vector<std::array<Vec3, 2>>& segments) {
  const Vec3 size = box.max - box.min;
  if (!(size.minCoeff() >= 0)) return;
  const double least = std::max(width, size.maxCoeff() / kMostCells);
  const double cell = least > 0 ? least : 1;
  // Two cubes more on each side have room for those that touch.
  corner_ = box.min.array() - 2 * cell;
  scale_ = 1 / cell;
  for (int axis = 0; axis < 3; ++axis) {
    counts_[axis] = static_cast<std::int64_t>(size[axis] * scale_) + 5;
  }
  row_ = (counts_[0] + kBits - 1) / kBits;
  words_.assign(static_cast<std::size_t>(row_ * counts_[1] * counts_[2]), 0);
  mark(segments);
}

void CellBits::mark(const std::vector<std::array<Vec3, 2>>& segments) {
  std::vector<std::uint64_t> passed(words_.size(), 0);
  for (const auto& [from, to] : segments) {
    const int steps = std::max(1, static_cast<int>(std::ceil((to - from).norm() * scale_)));
    for (int i = 0; i <= steps; ++i) {
      const std::array<std::int64_t, 3> cell =
          cell_of(from + (static_cast<double>(i) / steps) * (to - from));
      const std::uint64_t bit = std::uint64_t{1} << (cell[0] % kBits);
      std::uint64_t& word = passed[word_of(cell)];
      if ((word & bit) == 0) mark_round(cell);
      word |= bit;
    }
  }
}

// There is a cube on each side.
void CellBits::mark_round(const std::array<std::int64_t, 3>& cell) {
  const std::int64_t at = cell[0] % kBits;
  const std::uint64_t three = at > 0 ? std::uint64_t{7} << (at - 1) : 3;
  for (std::int64_t z = cell[2] - 1; z <= cell[2] + 1; ++z) {
    for (std::int64_t y = cell[1] - 1; y <= cell[1] + 1; ++y) {
      const std::size_t word = word_of({cell[0], y, z});
      words_[word] |= three;
      if (at == 0) words_[word - 1] |= std::uint64_t{1} << (kBits - 1);
      if (at == kBits - 1) words_[word + 1] |= 1;
    }
  }
}

}  // namespace kdm
