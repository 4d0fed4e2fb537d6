// SPDX-License-Identifier: MIT
// Measures how a triangle of a dual mesh lies and how thin it is.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/plane.h"

namespace kdm {

/// The cosine of the angle (about 78 degrees) between a triangle's normal and its hit's normal from
/// which the triangle counts as folded.
inline constexpr double kFolded = 0.2;

/// The sine of the angle (two degrees) below which a triangle's smallest angle makes it count as
/// thin.
inline constexpr double kThinSine = 0.035;

/// Computes once what the measures of a triangle have in common.
class TriangleShape {
 public:
  TriangleShape(const Vec3& a, const Vec3& b, const Vec3& c) {
    const Vec3 first = b - a;
    const Vec3 second = c - a;
    normal_ = first.cross(second);
    length_ = normal_.norm();
    squares_ = {first.squaredNorm(), second.squaredNorm(), (second - first).squaredNorm()};
  }

  /// Returns the cosine of the angle between the triangle's normal and a unit vector; -1 if the
  /// triangle is so thin that its normal has no direction.
  double alignment(const Vec3& wanted) const {
    constexpr double kFlattest = 1e-6;  // height over length
    if (!(length_ > kFlattest * longest())) return -1;
    return normal_.dot(wanted) / length_;
  }

  /// Returns the sine of the smallest angle, which lies between the two longer sides; 0 if all
  /// corners are one point.
  double least_sine() const {
    const auto& [x, y, z] = squares_;
    const double squares = std::max({x * y, y * z, z * x});
    return squares > 0 ? length_ / std::sqrt(squares) : 0;
  }

  /// Return the squared length of the shortest and of the longest side.
  double shortest() const { return *std::min_element(squares_.begin(), squares_.end()); }
  double longest() const { return *std::max_element(squares_.begin(), squares_.end()); }

 private:
  Vec3 normal_;
  double length_;
  std::array<double, 3> squares_;
};

/// Returns whether the three points lie on one line. Exact for 32-bit floats, unless some are
/// smaller than others by many orders of magnitude.
inline bool is_flat(const Vec3& a, const Vec3& b, const Vec3& c) {
  return (b - a).cross(c - a).isZero(0);
}

}  // namespace kdm
