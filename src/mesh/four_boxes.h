// SPDX-License-Identifier: MIT
// Four boxes at a time, for trees that are searched often.
#pragma once

#include <algorithm>
#include <array>
#include <limits>

#include "mesh/small_box.h"

namespace kdm {

/// Boxes with numbers from 0 to 3. The same bounds of all four stand side by side, so that one
/// instruction compares them. Boxes are empty until they are set.
class FourBoxes {
 public:
  /// A bit for each box, that of box 0 the lowest.
  using Bits = unsigned;

  void set(int i, const SmallBox& box) {
    for (int axis = 0; axis < 3; ++axis) {
      min_[axis][i] = box.min[axis];
      max_[axis][i] = box.max[axis];
    }
  }

  SmallBox operator[](int i) const {
    return {{min_[0][i], min_[1][i], min_[2][i]}, {max_[0][i], max_[1][i], max_[2][i]}};
  }

  /// Four times the same box, to hold others against.
  class Same;
  /// Tells which of the boxes meet another one, which may be infinite. Empty ones meet nothing.
  Bits meeting(const Same& box) const;

  /// Returns the squared distances of the boxes from another one, up to a few roundings in single
  /// precision; infinite ones for empty boxes.
  std::array<float, 4> squared_gaps(const Same& box) const;

  /// Returns the box round all four.
  SmallBox around() const {
    SmallBox all;
    for (int axis = 0; axis < 3; ++axis) {
      const Floats& low = min_[axis];
      const Floats& high = max_[axis];
      all.min[axis] = std::min(std::min(low[0], low[1]), std::min(low[2], low[3]));
      all.max[axis] = std::max(std::max(high[0], high[1]), std::max(high[2], high[3]));
    }
    return all;
  }

 private:
  // What GCC and clang make vector instructions of.
  using Floats = float __attribute__((vector_size(16)));
  using Ints = int __attribute__((vector_size(16)));

  static constexpr float kFar = SmallBox::kFar;

  static Floats four(float value) { return Floats{value, value, value, value}; }
  // The same for a bound that is finite, so that it lies beyond no bound of an empty box.
  static Floats four_finite(float value) {
    constexpr float kMost = std::numeric_limits<float>::max();
    return four(std::clamp(value, -kMost, kMost));
  }

  std::array<Floats, 3> min_ = {four(kFar), four(kFar), four(kFar)};
  std::array<Floats, 3> max_ = {four(-kFar), four(-kFar), four(-kFar)};
};

class FourBoxes::Same {
 public:
  explicit Same(const SmallBox& box)
      : min_{four_finite(box.min[0]), four_finite(box.min[1]), four_finite(box.min[2])},
        max_{four_finite(box.max[0]), four_finite(box.max[1]), four_finite(box.max[2])} {}

 private:
  friend class FourBoxes;
  std::array<Floats, 3> min_;
  std::array<Floats, 3> max_;
};

inline FourBoxes::Bits FourBoxes::meeting(const Same& box) const {
  const Ints all = (min_[0] <= box.max_[0]) & (min_[1] <= box.max_[1]) & (min_[2] <= box.max_[2]) &
                   (max_[0] >= box.min_[0]) & (max_[1] >= box.min_[1]) & (max_[2] >= box.min_[2]);
#if defined(__SSE__)
  return static_cast<Bits>(__builtin_ia32_movmskps(reinterpret_cast<Floats>(all)));
#elif defined(__wasm_simd128__)
  return static_cast<Bits>(__builtin_wasm_bitmask_i32x4(all));
#else
  const Ints bits = all & Ints{1, 2, 4, 8};
  return static_cast<Bits>((bits[0] | bits[1]) | (bits[2] | bits[3]));
#endif
}

inline std::array<float, 4> FourBoxes::squared_gaps(const Same& box) const {
  Floats sum{};
  for (int axis = 0; axis < 3; ++axis) {
    const Floats below = min_[axis] - box.max_[axis];
    const Floats above = box.min_[axis] - max_[axis];
    const Floats gap = below > above ? below : above;
    const Floats outside = gap > 0.0f ? gap : Floats{};
    sum += outside * outside;
  }
  return {sum[0], sum[1], sum[2], sum[3]};
}

}  // namespace kdm
