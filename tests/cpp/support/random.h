// SPDX-License-Identifier: MIT
// Random numbers for tests, the same on every platform: std::uniform_*_distribution differs between
// standard libraries.
#pragma once

#include <cstdint>
#include <random>

#include "kdmanifold/types.h"

namespace kdm::check {

/// A generator of random numbers.
class Random {
 public:
  explicit Random(std::uint32_t seed) : engine_(seed) {}

  /// Returns a number from 0 to limit - 1.
  std::uint32_t below(std::uint32_t limit) { return next() % limit; }
  bool coin() { return below(2) == 0; }
  /// Returns a number in [0, 1).
  double unit() { return next() / 4294967296.0; }
  double between(double lo, double hi) { return lo + (hi - lo) * unit(); }
  Vec3 point(double lo, double hi) {
    const double x = between(lo, hi);
    const double y = between(lo, hi);
    const double z = between(lo, hi);
    return Vec3(x, y, z);
  }
  /// Returns a unit vector; all directions are equally likely.
  Vec3 direction() {
    for (;;) {
      const Vec3 p = point(-1, 1);
      if (p.norm() > 0.1 && p.norm() < 1) return p.normalized();
    }
  }

 private:
  std::uint32_t next() { return static_cast<std::uint32_t>(engine_()); }
  std::mt19937 engine_;
};

}  // namespace kdm::check
