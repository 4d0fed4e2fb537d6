// SPDX-License-Identifier: MIT
// Defines how far apart points must be, and how large angles, so that double precision suffices.
#pragma once

#include <cmath>

#include "kdmanifold/types.h"

namespace kdm {

/// A point at least this far from a side of a box or face, in lattice units, lies on the computed
/// side of it in spite of all rounding.
inline constexpr double kClear = 1.0 / 32;
/// The least sine of an angle by which lengths are divided: a smaller one would enlarge rounding
/// errors too much.
inline constexpr double kLeastSine = 1.0 / 4096;

inline bool nearly_parallel(const Vec3& direction, int axis) {
  return std::abs(direction[axis]) < kLeastSine * direction.cwiseAbs().maxCoeff();
}

}  // namespace kdm
