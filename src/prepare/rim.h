// SPDX-License-Identifier: MIT
// Computes points and planes at the rim of a surface, which consists of the triangle sides without
// opposite. All coordinates and lengths are in lattice units.
#pragma once

#include "prepare/surface.h"

namespace kdm {

/// Returns the plane that contains a side of a triangle and stands upright on the triangle, whose
/// normal is `face_normal`. If `face_normal` is zero, so is the normal of the plane.
Plane rim_plane(const Surface& surface, SideId side, const Vec3& face_normal);

/// Returns the point where the side crosses the lattice plane at `value` along `axis`. The side
/// must cross this plane.
Vec3 rim_point(const Surface& surface, SideId side, int axis, std::int32_t value);

/// Returns about the middle of the part of the side that lies in the box.
Vec3 rim_middle(const Surface& surface, SideId side, const LatticeBox& box);

/// Tells whether two rims that cross a lattice plane at these points are so near to each other that
/// they may have been one before their corners were rounded.
inline bool is_seam(const Vec3& a, const Vec3& b) {
  constexpr double kMostDistance = 2;  // rounding moves a corner by less than one lattice unit
  return (a - b).norm() <= kMostDistance;
}

}  // namespace kdm
