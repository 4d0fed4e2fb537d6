// SPDX-License-Identifier: MIT
// Exact signs of volumes and areas of points in floating point. A sign is computed in double first,
// together with a bound of the error. Where the bound is larger than the value, it is computed
// again as an exact sum of doubles, an expansion (J. R. Shewchuk, Adaptive Precision Floating-Point
// Arithmetic and Fast Robust Geometric Predicates, 1997).
//
// They are exact as long as products of three coordinate differences neither overflow nor
// underflow: scale coordinates to about 1 first.
#pragma once

#include "kdmanifold/types.h"

namespace kdm {

/// Returns the sign of the volume of (a, b, c, d): 1 if d is on the side from which a, b, c are
/// seen counter-clockwise.
int volume_sign(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

/// Returns the sign of the area of (a, b, c) seen along `axis`: 1 if they are counter-clockwise in
/// the plane of the next and the previous axis.
int area_sign(const Vec3& a, const Vec3& b, const Vec3& c, int axis);

/// Tells whether (a, b, c) do not lie on one line.
bool has_area(const Vec3& a, const Vec3& b, const Vec3& c);

}  // namespace kdm
