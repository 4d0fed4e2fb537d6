// SPDX-License-Identifier: MIT
// An oriented plane.
#pragma once

#include <cmath>

#include "kdmanifold/types.h"

namespace kdm {

/// A plane in unrounded lattice coordinates: normal . x = offset, |normal| = 1.
struct Plane {
  Vec3 normal = Vec3::Zero();
  double offset = 0;

  bool operator==(const Plane&) const = default;

  /// Returns the distance of a point from the plane in lattice units, positive on the side that the
  /// normal points to.
  double signed_distance(const Vec3& p) const { return normal.dot(p) - offset; }
  double distance(const Vec3& p) const { return std::abs(signed_distance(p)); }
};

}  // namespace kdm
