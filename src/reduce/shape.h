// SPDX-License-Identifier: MIT
// How far triangles are from slivers.
#pragma once

#include <algorithm>

#include "geometry/triangle.h"

namespace kdm {

/// The shape of a triangle that counts as a sliver: below this.
inline constexpr double kLeastShape = 0.02;

/// Returns twice the area of a triangle over the square of its longest side: 0 for none, 0.87 for
/// three equal sides.
inline double shape_of(const Vec3& a, const Vec3& b, const Vec3& c, double doubled_area) {
  const double longest =
      std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
  return longest > 0 ? doubled_area / longest : 0;
}
inline double shape_of(const Vec3& a, const Vec3& b, const Vec3& c) {
  return shape_of(a, b, c, doubled_area_vector(a, b, c).norm());
}

}  // namespace kdm
