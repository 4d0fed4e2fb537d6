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

/// Returns the squared distance of p from the triangle (a, b, c), which may be without area. Finds
/// out by signs which corner, side or inner point is nearest (C. Ericson, Real-Time Collision
/// Detection, 2005, 5.1.5).
inline double squared_distance(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 ab = b - a;
  const Vec3 ac = c - a;
  const Vec3 ap = p - a;
  const double ab_ap = ab.dot(ap);
  const double ac_ap = ac.dot(ap);
  if (ab_ap <= 0 && ac_ap <= 0) return ap.squaredNorm();
  const Vec3 bp = p - b;
  const double ab_bp = ab.dot(bp);
  const double ac_bp = ac.dot(bp);
  if (ab_bp >= 0 && ac_bp <= ab_bp) return bp.squaredNorm();
  // The barycentric coordinates of the foot of the perpendicular, times the same number.
  const double to_c = ab_ap * ac_bp - ab_bp * ac_ap;
  if (to_c <= 0 && ab_ap >= 0 && ab_bp <= 0 && ab_ap > ab_bp) {
    return (ap - (ab_ap / (ab_ap - ab_bp)) * ab).squaredNorm();
  }
  const Vec3 cp = p - c;
  const double ab_cp = ab.dot(cp);
  const double ac_cp = ac.dot(cp);
  if (ac_cp >= 0 && ab_cp <= ac_cp) return cp.squaredNorm();
  const double to_b = ab_cp * ac_ap - ab_ap * ac_cp;
  if (to_b <= 0 && ac_ap >= 0 && ac_cp <= 0 && ac_ap > ac_cp) {
    return (ap - (ac_ap / (ac_ap - ac_cp)) * ac).squaredNorm();
  }
  const double to_a = ab_bp * ac_cp - ab_cp * ac_bp;
  const double from_b = ac_bp - ab_bp;
  const double from_c = ab_cp - ac_cp;
  if (to_a <= 0 && from_b >= 0 && from_c >= 0 && from_b + from_c > 0) {
    return (bp - (from_b / (from_b + from_c)) * (c - b)).squaredNorm();
  }
  const double sum = to_a + to_b + to_c;
  return (ap - (to_b / sum) * ab - (to_c / sum) * ac).squaredNorm();
}

}  // namespace kdm
