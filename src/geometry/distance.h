// SPDX-License-Identifier: MIT
// Squared distances between points and parts of triangles.
#pragma once

#include <algorithm>

#include "kdmanifold/types.h"

namespace kdm {

/// Returns the squared distance of p from the segment from a to b.
inline double squared_distance(const Vec3& p, const Vec3& a, const Vec3& b) {
  const Vec3 along = b - a;
  const double length = along.squaredNorm();
  const double t = length > 0 ? std::clamp(along.dot(p - a) / length, 0.0, 1.0) : 0.0;
  return (p - a - t * along).squaredNorm();
}

/// Returns the squared distance of p from the triangle (a, b, c), which may be without area.
inline double squared_distance(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 u = b - a;
  const Vec3 v = c - a;
  const Vec3 w = p - a;
  // s and t are the barycentric coordinates of the foot of the perpendicular, times `area`, which
  // is four times the square of the triangle's area.
  const double uu = u.dot(u);
  const double uv = u.dot(v);
  const double vv = v.dot(v);
  const double area = uu * vv - uv * uv;
  const double s = vv * u.dot(w) - uv * v.dot(w);
  const double t = uu * v.dot(w) - uv * u.dot(w);
  if (area > 0 && s >= 0 && t >= 0 && s + t <= area) {
    return (w - (s / area) * u - (t / area) * v).squaredNorm();
  }
  return std::min(
      {squared_distance(p, a, b), squared_distance(p, b, c), squared_distance(p, c, a)});
}

}  // namespace kdm
