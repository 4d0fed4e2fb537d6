// SPDX-License-Identifier: MIT
#include "mesh/small_box.h"

#include <algorithm>
#include <cmath>

namespace kdm {
namespace {

// Twice what rounding to single precision may change, as a share of the value.
constexpr double kFloatRounding = 0x1p-23;
// More than that where numbers are too small to be rounded by a share.
constexpr double kLeast = 0x1p-140;

double rounding_of(double value) { return kFloatRounding * std::abs(value) + kLeast; }

float below(double value) { return static_cast<float>(value - rounding_of(value)); }
float above(double value) { return static_cast<float>(value + rounding_of(value)); }

}  // namespace

void SmallBox::grow(const Vec3& p) {
  for (int axis = 0; axis < 3; ++axis) {
    min[axis] = std::min(min[axis], below(p[axis]));
    max[axis] = std::max(max[axis], above(p[axis]));
  }
}

void SmallBox::grow(const SmallBox& other) {
  for (int axis = 0; axis < 3; ++axis) {
    min[axis] = std::min(min[axis], other.min[axis]);
    max[axis] = std::max(max[axis], other.max[axis]);
  }
}

SmallBox small_box(const Vec3& a, const Vec3& b, const Vec3& c) {
  SmallBox box;
  for (int axis = 0; axis < 3; ++axis) {
    box.min[axis] = below(std::min({a[axis], b[axis], c[axis]}));
    box.max[axis] = above(std::max({a[axis], b[axis], c[axis]}));
  }
  return box;
}

SmallBox small_box(const Vec3& centre, double radius) {
  SmallBox box;
  for (int axis = 0; axis < 3; ++axis) {
    box.min[axis] = below(centre[axis] - radius);
    box.max[axis] = above(centre[axis] + radius);
  }
  return box;
}

}  // namespace kdm
