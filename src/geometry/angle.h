// SPDX-License-Identifier: MIT
// Angles without libm's functions, whose last bits differ between platforms.
#pragma once

#include <algorithm>
#include <cmath>

#include "kdmanifold/types.h"

namespace kdm {

/// Of x from 0 to 1, to 1e-10.
inline double arc_tangent(double x) {
  // atan x = pi/8 + atan((x - t) / (1 + x t)) with t = tan(pi/8); what is left is small.
  constexpr double kTangent = 0.41421356237309503;
  constexpr double kEighth = 0.39269908169872414;
  const double y = (x - kTangent) / (1 + x * kTangent);
  const double square = y * y;
  double sum = 0;
  for (int k = 23; k >= 1; k -= 2) sum = 1.0 / k - square * sum;
  return kEighth + y * sum;
}

/// The angle between two vectors in radians, 0 to pi; 0 if one has no length.
inline double angle_between(const Vec3& a, const Vec3& b) {
  constexpr double kQuarter = 0.7853981633974483;
  const double lengths[] = {a.norm(), b.norm()};
  if (!(lengths[0] > 0 && lengths[1] > 0)) return 0;
  const Vec3 u = a / lengths[0];
  const Vec3 v = b / lengths[1];
  // The tangent of half of it is difference / sum.
  const double difference = (u - v).norm();
  const double sum = (u + v).norm();
  return difference <= sum ? 2 * arc_tangent(difference / sum)
                           : 4 * kQuarter - 2 * arc_tangent(sum / difference);
}

}  // namespace kdm
