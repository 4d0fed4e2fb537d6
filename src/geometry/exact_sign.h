// SPDX-License-Identifier: MIT
// Signs of volumes and areas of points in floating point, exact: first in double with a bound of
// its error, then, where that does not decide, with expansions (J. R. Shewchuk, Adaptive Precision
// Floating-Point Arithmetic and Fast Robust Geometric Predicates, 1997).
//
// Exact as long as products of three coordinate differences neither overflow nor underflow: scale
// to about 1 first.
#pragma once

#include "kdmanifold/types.h"

namespace kdm {

/// Sign of the volume of (a, b, c, d): positive if d is on the side that the normal of a, b, c,
/// seen counter-clockwise, points to.
int volume_sign(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

/// Sign of the area of (a, b, c) seen along `axis`: positive if counter-clockwise.
int area_sign(const Vec3& a, const Vec3& b, const Vec3& c, int axis);

}  // namespace kdm
