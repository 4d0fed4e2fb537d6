// SPDX-License-Identifier: MIT
// The squared distance of two triangles.
#pragma once

#include <algorithm>
#include <array>

#include <Eigen/Geometry>

#include "geometry/distance.h"

namespace kdm {

/// Returns the squared distance of the segments from a to b and from c to d, each of which may be a
/// point.
inline double squared_segment_distance(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const double nearest_end = std::min({squared_distance(a, c, d), squared_distance(b, c, d),
                                       squared_distance(c, a, b), squared_distance(d, a, b)});
  const Vec3 u = b - a;
  const Vec3 v = d - c;
  const Vec3 w = c - a;
  const double uu = u.dot(u);
  const double uv = u.dot(v);
  const double vv = v.dot(v);
  const double area = uu * vv - uv * uv;
  // s and t are the places of the feet of the common perpendicular, times `area`.
  const double s = vv * u.dot(w) - uv * v.dot(w);
  const double t = uv * u.dot(w) - uu * v.dot(w);
  if (!(area > 0) || s < 0 || s > area || t < 0 || t > area) return nearest_end;
  return std::min(nearest_end, (w + (t / area) * v - (s / area) * u).squaredNorm());
}

/// Tells whether the segment from p to q passes through the triangle, but for rounding: false where
/// one of its ends lies in the triangle's plane, or both do.
inline bool passes_through(const Vec3& p, const Vec3& q, const std::array<Vec3, 3>& triangle) {
  constexpr double kRounding = 1e-12;
  const auto& [a, b, c] = triangle;
  const Vec3 normal = (b - a).cross(c - a);
  const double above = normal.dot(p - a);
  const double below = normal.dot(q - a);
  const double least = kRounding * normal.norm() * std::max((p - a).norm(), (q - a).norm());
  if (!(std::min(above, below) < -least && std::max(above, below) > least)) return false;
  const Vec3 way = q - p;
  const double side = way.dot((a - p).cross(b - p));
  return (way.dot((b - p).cross(c - p)) > 0) == (side > 0) &&
         (way.dot((c - p).cross(a - p)) > 0) == (side > 0);
}

/// Returns the squared distance of two triangles; 0 if they cross.
inline double squared_distance(const std::array<Vec3, 3>& a, const std::array<Vec3, 3>& b) {
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t next = i == 2 ? 0 : i + 1;
    if (passes_through(a[i], a[next], b) || passes_through(b[i], b[next], a)) return 0;
  }
  double least = squared_distance(a[0], b[0], b[1], b[2]);
  for (int i = 0; i < 3; ++i) {
    least = std::min({least, squared_distance(a[i], b[0], b[1], b[2]),
                      squared_distance(b[i], a[0], a[1], a[2])});
    for (int j = 0; j < 3; ++j) {
      least = std::min(least, squared_segment_distance(a[i], a[i == 2 ? 0 : i + 1], b[j],
                                                       b[j == 2 ? 0 : j + 1]));
    }
  }
  return least;
}

}  // namespace kdm
