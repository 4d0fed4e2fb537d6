// SPDX-License-Identifier: MIT
// How far apart things must be for double precision to tell them apart.
#pragma once

#include <cmath>

#include "kdmanifold/types.h"

namespace kdm {

/// Points this far off a side, in lattice units, are clear of it whatever is rounded in between.
inline constexpr double kClear = 1.0 / 32;
/// Smaller sines than this multiply what is rounded too much.
inline constexpr double kLeastSine = 1.0 / 4096;

inline bool nearly_parallel(const Vec3& direction, int axis) {
  return std::abs(direction[axis]) < kLeastSine * direction.cwiseAbs().maxCoeff();
}

}  // namespace kdm
