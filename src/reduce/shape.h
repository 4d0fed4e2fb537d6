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

/// What tests ask of a triangle again and again.
struct FaceShape {
  Vec3 normal = Vec3::Zero();  ///< of length 1; zero if there is no area
  double doubled_area = 0;
  double shape = 0;  ///< see `shape_of`
};

inline FaceShape face_shape(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 area = doubled_area_vector(a, b, c);
  const double size = area.norm();
  const Vec3 normal = size > 0 ? Vec3(area / size) : Vec3(Vec3::Zero());
  return {normal, size, shape_of(a, b, c, size)};
}

}  // namespace kdm
