// SPDX-License-Identifier: MIT
// How a triangle of a dual mesh lies and how thin it is.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "geometry/plane.h"

namespace kdm {

/// A triangle further than about 78 degrees off its plane is folded: cosine.
inline constexpr double kFolded = 0.2;

/// One whose smallest angle is below two degrees is thin: sine.
inline constexpr double kThinSine = 0.035;

/// Cosine between the triangle's normal and a unit vector; -1 if it is so thin that it has no
/// direction.
inline double alignment(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& wanted) {
  constexpr double kFlat = 1e-6;  // height over length
  const Vec3 first = b - a;
  const Vec3 second = c - a;
  const Vec3 normal = first.cross(second);
  const double length = normal.norm();
  const double longest =
      std::max({first.squaredNorm(), second.squaredNorm(), (second - first).squaredNorm()});
  if (!(length > kFlat * longest)) return -1;
  return normal.dot(wanted) / length;
}

/// Of the smallest angle, which lies between the two longer sides; 0 if corners are one point.
inline double least_sine(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 first = b - a;
  const Vec3 second = c - a;
  const double x = first.squaredNorm();
  const double y = second.squaredNorm();
  const double z = (second - first).squaredNorm();
  const double squares = std::max({x * y, y * z, z * x});
  return squares > 0 ? first.cross(second).norm() / std::sqrt(squares) : 0;
}

/// Are the three points, of 32-bit coordinates, on one line?
inline bool is_flat(const Vec3& a, const Vec3& b, const Vec3& c) {
  return (b - a).cross(c - a).isZero(0);
}

}  // namespace kdm
