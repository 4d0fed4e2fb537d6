// SPDX-License-Identifier: MIT
// The rim of a sheet: sides of triangles that have no twin.
#pragma once

#include "prepare/surface.h"

namespace kdm {

/// The plane through the side of a triangle (numbered as in Topology) that stands upright on the
/// triangle, whose normal is given; zero where that is.
Plane rim_plane(const Surface& surface, Index side, const Vec3& face_normal);

/// The point where the side crosses the lattice plane `value` of `axis`, which it must.
Vec3 rim_point(const Surface& surface, Index side, int axis, std::int32_t value);

/// The middle of the side's part in the box, rounded.
Vec3 rim_middle(const Surface& surface, Index side, const LatticeBox& box);

/// Were two rims that leave a face at these points one before rounding?
inline bool is_seam(const Vec3& a, const Vec3& b) {
  constexpr double kSeam = 2;  // lattice units
  return (a - b).norm() <= kSeam;
}

}  // namespace kdm
