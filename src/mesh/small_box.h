// SPDX-License-Identifier: MIT
// Boxes that take half of the memory of others (`Box`): for lists that are read often.
#pragma once

#include <array>
#include <limits>

#include "kdmanifold/types.h"

namespace kdm {

/// A box in single precision, which is larger than what it was made for by a rounding error or two.
struct SmallBox {
  std::array<float, 3> min = {kFar, kFar, kFar};
  std::array<float, 3> max = {-kFar, -kFar, -kFar};

  static constexpr float kFar = std::numeric_limits<float>::infinity();

  /// Widens the box so that it surely holds the point.
  void grow(const Vec3& p);
  void grow(const SmallBox& other);
  bool meets(const SmallBox& other) const {
    return min[0] <= other.max[0] && min[1] <= other.max[1] && min[2] <= other.max[2] &&
           max[0] >= other.min[0] && max[1] >= other.min[1] && max[2] >= other.min[2];
  }
  bool operator==(const SmallBox&) const = default;
};

/// Returns the box round the points.
SmallBox small_box(const Vec3& a, const Vec3& b, const Vec3& c);
/// Returns the box that holds all points no further from `centre` than `radius`, and a little more.
SmallBox small_box(const Vec3& centre, double radius);

}  // namespace kdm
