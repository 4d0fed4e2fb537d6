// SPDX-License-Identifier: MIT
// Finds the minimal face that a link passes through.
#pragma once

#include <optional>

#include "extract/dual/dual_mesh.h"

namespace kdm {

/// A rectangle between two leaves: the overlap of a side of one leaf with a side of the other leaf.
/// Lattice coordinates.
struct LinkFace {
  Vec3 lo;
  Vec3 hi;
  int axis;  ///< the rectangle's normal is along this axis: lo and hi agree there
};

/// Finds the rectangle between the boxes of two leaves. Returns nothing where the boxes touch in
/// less than a rectangle, as they do across a strip.
std::optional<LinkFace> face_between(const LatticeBox& first, const LatticeBox& second);

/// Returns the point of the face that is nearest to `point` and keeps off the face's sides: by 1/64
/// of its size or by `margin` (lattice units), whichever is less.
Vec3 off_sides(const LinkFace& face, const Vec3& point, double margin);

/// Tells whether a point of the face's plane lies in the face and clear of its sides (`kClear`).
bool within(const LinkFace& face, const Vec3& point);

}  // namespace kdm
