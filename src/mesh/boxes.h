// SPDX-License-Identifier: MIT
// Boxes around points, triangles and other boxes.
#pragma once

#include "kdmanifold/types.h"

namespace kdm {

/// Widens the box, which may be empty, so that it holds the point.
inline void grow(Box& box, const Vec3& p) {
  const bool empty = box.min.x() > box.max.x();
  box.min = empty ? p : Vec3(box.min.cwiseMin(p));
  box.max = empty ? p : Vec3(box.max.cwiseMax(p));
}

/// Widens `box` so that it holds `other`. Neither box may be empty.
inline void grow(Box& box, const Box& other) {
  box.min = box.min.cwiseMin(other.min);
  box.max = box.max.cwiseMax(other.max);
}

/// Returns the smallest box that holds the triangle (a, b, c).
inline Box box_of(const Vec3& a, const Vec3& b, const Vec3& c) {
  return {a.cwiseMin(b).cwiseMin(c), a.cwiseMax(b).cwiseMax(c)};
}

inline Vec3 centre_of(const Box& box) { return box.min + (box.max - box.min) / 2; }

}  // namespace kdm
