// SPDX-License-Identifier: MIT
// Measures of triangles in floating point.
#pragma once

#include <Eigen/Geometry>

#include "kdmanifold/types.h"

namespace kdm {

/// Returns the cross product of two sides: twice the area vector of the triangle (a, b, c). It
/// stands upright on the triangle, points to where the corners are seen counter-clockwise, and is
/// twice as long as the area is large. (`area_vector` in predicates.h is the same on the lattice,
/// exactly.)
inline Vec3 doubled_area_vector(const Vec3& a, const Vec3& b, const Vec3& c) {
  return (b - a).cross(c - a);
}

/// Returns the vector divided by its length, or zero if it has none.
inline Vec3 normalized_or_zero(const Vec3& v) {
  const double length = v.norm();
  return length > 0 ? Vec3(v / length) : Vec3(Vec3::Zero());
}

/// Returns the unit normal of the triangle (a, b, c), or zero if it has no area.
inline Vec3 unit_normal(const Vec3& a, const Vec3& b, const Vec3& c) {
  return normalized_or_zero(doubled_area_vector(a, b, c));
}

}  // namespace kdm
