// SPDX-License-Identifier: MIT
// Marks cubes by steps along segments, and grows the marks a word at a time.
#include "reduce/cell_bits.h"

#include <algorithm>
#include <cmath>

namespace kdm {
namespace {

constexpr double kMostCells = 512;

// Marks each word with what its neighbours had, `step` words on and back, within blocks of `block`.
void spread_words(std::vector<std::uint64_t>& words, std::size_t step, std::size_t block) {
  const std::vector<std::uint64_t> before = words;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::size_t place = i % block;
    if (place >= step) words[i] |= before[i - step];
    if (place + step < block) words[i] |= before[i + step];
  }
}

}  // namespace

CellBits::CellBits(const Box& box, double width) {
  const Vec3 size = box.max - box.min;
  if (!(size.minCoeff() >= 0)) return;
  const double least = std::max(width, size.maxCoeff() / kMostCells);
  const double cell = least > 0 ? least : 1;
  // Two cubes more on each side have room for what grows.
  corner_ = box.min.array() - 2 * cell;
  scale_ = 1 / cell;
  for (int axis = 0; axis < 3; ++axis) {
    counts_[axis] = static_cast<std::int64_t>(size[axis] * scale_) + 5;
  }
  row_ = (counts_[0] + kBits - 1) / kBits;
  words_.assign(static_cast<std::size_t>(row_ * counts_[1] * counts_[2]), 0);
}

void CellBits::mark(const Vec3& from, const Vec3& to) {
  const int steps = std::max(1, static_cast<int>(std::ceil((to - from).norm() * scale_)));
  for (int i = 0; i <= steps; ++i) {
    const std::array<std::int64_t, 3> cell =
        cell_of(from + (static_cast<double>(i) / steps) * (to - from));
    words_[word_of(cell)] |= std::uint64_t{1} << (cell[0] % kBits);
  }
}

void CellBits::grow() {
  std::vector<std::uint64_t> grown = words_;
  for (std::size_t i = 0; i < words_.size(); ++i) {
    const std::int64_t place = static_cast<std::int64_t>(i) % row_;
    grown[i] |= words_[i] << 1 | words_[i] >> 1;
    if (place > 0) grown[i] |= words_[i - 1] >> (kBits - 1);
    if (place + 1 < row_) grown[i] |= words_[i + 1] << (kBits - 1);
  }
  words_ = std::move(grown);
  const std::size_t row = static_cast<std::size_t>(row_);
  const std::size_t slice = row * static_cast<std::size_t>(counts_[1]);
  spread_words(words_, row, slice);
  spread_words(words_, slice, words_.size());
}

}  // namespace kdm
