// SPDX-License-Identifier: MIT
// Points that stand for the area of triangles.
#pragma once

#include <cmath>
#include <cstdint>

#include "kdmanifold/types.h"

namespace kdm {

/// Spreads points over the area of triangles, taken in turn: as many points a unit of area
/// everywhere.
class Spread {
 public:
  /// `area` is that for which there is one point.
  explicit Spread(double area) : area_(area) {}

  /// Calls `visit(point)` for the points of the next triangle.
  template <typename Visit>
  void for_each_point(const Vec3& a, const Vec3& b, const Vec3& c, double area,
                      const Visit& visit) {
    sum_ += area;
    const auto end = static_cast<std::uint64_t>(std::floor(sum_ / area_ + 0.5));
    for (; next_ < end; ++next_) {
      // Fractions of the multiples of these fill the unit square evenly; half of it is folded over.
      double u = fraction(0.7548776662466927 * static_cast<double>(next_));
      double v = fraction(0.5698402909980532 * static_cast<double>(next_));
      if (u + v > 1) {
        u = 1 - u;
        v = 1 - v;
      }
      visit(Vec3(a + u * (b - a) + v * (c - a)));
    }
  }

 private:
  static double fraction(double x) { return x - std::floor(x); }

  double area_;
  double sum_ = 0;
  std::uint64_t next_ = 0;
};

}  // namespace kdm
