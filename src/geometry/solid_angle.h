// SPDX-License-Identifier: MIT
// Solid angles and their sums by square roots and a series, so that every platform finds the same
// bits.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/angle.h"
#include "kdmanifold/types.h"

namespace kdm {

/// Adds up angles, each given as a direction (re, im) in the plane. It multiplies the directions as
/// complex numbers and counts full turns, so that one arc tangent is enough for any number of
/// angles.
class AngleSum {
 public:
  /// Adds the angle of (re, im), which is in (-pi, pi]; (0, 0) adds nothing. Neither number may
  /// exceed 1e100, and not both may be smaller than 1e-100.
  void add(double re, double im) {
    if (re == 0 && im == 0) return;
    const double product_re = re_ * re - im_ * im;
    const double product_im = re_ * im + im_ * re;
    // If the directions of two angles are in one half-plane and that of their sum is in the other,
    // the sum has passed half a turn. Two angles of pi are a full turn.
    const bool whole = product_im == 0 && product_re > 0 && re < 0;
    if (im_ >= 0 && im >= 0 && (product_im < 0 || whole)) ++turns_;
    if (im_ < 0 && im < 0 && product_im >= 0) --turns_;
    re_ = product_re;
    im_ = product_im;
    const double size = std::max(std::abs(re_), std::abs(im_));
    if (size > 1e100 || size < 1e-100) {
      re_ /= size;
      im_ /= size;
    }
  }

  /// Returns the sum in full turns.
  double turns() const {
    constexpr double kTurn = 6.283185307179586;
    double angle = 0;
    if (std::abs(re_) >= std::abs(im_)) {
      angle = arc_tangent(im_ / re_);
      if (re_ < 0) angle += im_ < 0 ? -kTurn / 2 : kTurn / 2;
    } else {
      angle = (im_ < 0 ? -kTurn / 4 : kTurn / 4) - arc_tangent(re_ / im_);
    }
    return turns_ + angle / kTurn;
  }

 private:
  double re_ = 1;
  double im_ = 0;
  double turns_ = 0;
};

/// Half the solid angle that a triangle fills, seen from the origin, as a direction in the plane
/// for `AngleSum` (A. van Oosterom, J. Strackee, The solid angle of a plane triangle, 1983). It is
/// positive where the triangle's back is seen.
struct HalfSolidAngle {
  double re;
  double im;

  HalfSolidAngle(const Vec3& a, const Vec3& b, const Vec3& c) {
    const double la = a.norm();
    const double lb = b.norm();
    const double lc = c.norm();
    im = a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
         a[2] * (b[0] * c[1] - b[1] * c[0]);
    re = la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb;
  }
};

/// Returns the gradient of the solid angle that a triangle fills: how it changes as the point moves
/// from which the triangle is seen. The corners are given relative to that point. The gradient is a
/// sum over the triangle's sides, like the magnetic field of a current along them (law of Biot and
/// Savart). A side that passes through the point, where the gradient is infinite, is left out.
inline Vec3 solid_angle_gradient(const std::array<Vec3, 3>& corners) {
  Vec3 sum = Vec3::Zero();
  for (int i = 0; i < 3; ++i) {
    const Vec3& a = corners[i];
    const Vec3& b = corners[i == 2 ? 0 : i + 1];
    const double la = a.norm();
    const double lb = b.norm();
    const double product = la * lb;
    const double apart = product + a.dot(b);
    if (!(apart > 1e-12 * product)) continue;
    const Vec3 upright(a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
                       a[0] * b[1] - a[1] * b[0]);
    sum += (la + lb) / (product * apart) * upright;
  }
  return sum;
}

}  // namespace kdm
