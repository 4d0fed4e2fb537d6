// SPDX-License-Identifier: MIT
// Area and enclosed volume as sums over triangles, in one order of operations everywhere.
#pragma once

#include <Eigen/Geometry>
#include <cmath>

#include "kdmanifold/types.h"

namespace kdm {

/// Widens the box to hold p.
inline void grow(Box& box, const Vec3& p) {
  const bool empty = box.min.x() > box.max.x();
  box.min = empty ? p : Vec3(box.min.cwiseMin(p));
  box.max = empty ? p : Vec3(box.max.cwiseMax(p));
}

inline Vec3 centre_of(const Box& box) { return box.min + (box.max - box.min) / 2; }

/// Seen from the middle of the box the terms are small, and so are their rounding errors.
struct Measure {
  Vec3 centre = Vec3::Zero();
  double area = 0;
  double volume = 0;
  double absolute_volume = 0;  ///< the terms' absolute values: what rounding errors compare with

  void add(const Vec3& p, const Vec3& q, const Vec3& r) {
    const Vec3 a = p - centre;
    const Vec3 b = q - centre;
    const Vec3 c = r - centre;
    const Vec3 n = (b - a).cross(c - a);
    area += std::sqrt(n.x() * n.x() + n.y() * n.y() + n.z() * n.z()) / 2;
    const double term = (a.x() * n.x() + a.y() * n.y() + a.z() * n.z()) / 6;
    volume += term;
    absolute_volume += std::abs(term);
  }
};

}  // namespace kdm
