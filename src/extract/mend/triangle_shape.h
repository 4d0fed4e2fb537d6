// SPDX-License-Identifier: MIT
// How a triangle of a dual mesh lies and how thin it is.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/plane.h"

namespace kdm {

/// A triangle further than about 78 degrees off its plane is folded: cosine.
inline constexpr double kFolded = 0.2;

/// One whose smallest angle is below two degrees is thin: sine.
inline constexpr double kThinSine = 0.035;

/// What is needed to tell how a triangle of these corners lies and how thin it is.
class TriangleShape {
 public:
  TriangleShape(const Vec3& a, const Vec3& b, const Vec3& c) {
    const Vec3 first = b - a;
    const Vec3 second = c - a;
    normal_ = first.cross(second);
    length_ = normal_.norm();
    squares_ = {first.squaredNorm(), second.squaredNorm(), (second - first).squaredNorm()};
  }

  /// Cosine between the triangle's normal and a unit vector; -1 if it is so thin that it has no
  /// direction.
  double alignment(const Vec3& wanted) const {
    constexpr double kFlat = 1e-6;  // height over length
    if (!(length_ > kFlat * longest())) return -1;
    return normal_.dot(wanted) / length_;
  }

  /// Of the smallest angle, which lies between the two longer sides; 0 if corners are one point.
  double least_sine() const {
    const auto& [x, y, z] = squares_;
    const double squares = std::max({x * y, y * z, z * x});
    return squares > 0 ? length_ / std::sqrt(squares) : 0;
  }

  /// Squared lengths of the sides.
  double shortest() const { return *std::min_element(squares_.begin(), squares_.end()); }
  double longest() const { return *std::max_element(squares_.begin(), squares_.end()); }

 private:
  Vec3 normal_;
  double length_;
  std::array<double, 3> squares_;
};

/// Are the three points, of 32-bit coordinates, on one line?
inline bool is_flat(const Vec3& a, const Vec3& b, const Vec3& c) {
  return (b - a).cross(c - a).isZero(0);
}

}  // namespace kdm
