// SPDX-License-Identifier: MIT
// Angles from square roots and a series: the last bits of libm's functions differ between
// platforms.
#pragma once

#include <cmath>

#include "kdmanifold/types.h"

namespace kdm {

/// Returns the arc tangent of x in radians, within 1e-14.
inline double arc_tangent(double x) {
  // Two halvings of the angle bring |x| below tan(pi / 8) / 2.
  for (int i = 0; i < 2; ++i) x /= 1.0 + std::sqrt(1.0 + x * x);
  const double square = x * x;
  double sum = 0;
  for (int k = 19; k >= 1; k -= 2) sum = 1.0 / k - square * sum;
  return 4.0 * x * sum;
}

/// Returns the angle between two vectors in radians, from 0 to pi; 0 if one of them has no length.
inline double angle_between(const Vec3& a, const Vec3& b) {
  constexpr double kQuarter = 0.7853981633974483;
  const double lengths[] = {a.norm(), b.norm()};
  if (!(lengths[0] > 0 && lengths[1] > 0)) return 0;
  const Vec3 u = a / lengths[0];
  const Vec3 v = b / lengths[1];
  // The tangent of half the angle is difference / sum.
  const double difference = (u - v).norm();
  const double sum = (u + v).norm();
  return difference <= sum ? 2 * arc_tangent(difference / sum)
                           : 4 * kQuarter - 2 * arc_tangent(sum / difference);
}

}  // namespace kdm
