// SPDX-License-Identifier: MIT
#include "mesh/small_box.h"

#include <cmath>

namespace kdm {
namespace {

// Twice what rounding to single precision may change, as a share of the value.
constexpr double kFloatRounding = 0x1p-23;
// More than that where numbers are too small to be rounded by a share.
constexpr double kLeast = 0x1p-140;

double rounding_of(double value) { return kFloatRounding * std::abs(value) + kLeast; }

}  // namespace

void SmallBox::grow(const Vec3& p) {
  for (int axis = 0; axis < 3; ++axis) {
    const double rounding = rounding_of(p[axis]);
    min[axis] = std::min(min[axis], static_cast<float>(p[axis] - rounding));
    max[axis] = std::max(max[axis], static_cast<float>(p[axis] + rounding));
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
  box.grow(a);
  box.grow(b);
  box.grow(c);
  return box;
}

SmallBox small_box(const Vec3& centre, double radius) {
  SmallBox box;
  box.grow(Vec3(centre.array() - radius));
  box.grow(Vec3(centre.array() + radius));
  return box;
}

}  // namespace kdm
