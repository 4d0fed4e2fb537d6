// SPDX-License-Identifier: MIT
// Which mesh elements meet which boxes: exact, under the perturbation of predicates.h.
//
// Convex sets are disjoint iff one of finitely many directions separates them. Seen along an axis,
// such a direction is a mesh edge against the corners of the box's outline, which are grid lines:
// so every test is one of the signs of predicates.h. A box may be flat (lo == hi on one axis):
// then it is a rectangle in a lattice plane. Volumes and areas are open sets.
#pragma once

#include "geometry/predicates.h"

namespace kdm {

bool vertex_in_box(const LatticePoint& p, const LatticeBox& box);
bool edge_meets_box(const LatticePoint& a, const LatticePoint& b, const LatticeBox& box);
bool triangle_meets_box(const LatticeTriangle& t, const LatticeBox& box);

/// The polygon that is left of a triangle within a box, rounded: at most nine corners.
struct ClippedPolygon {
  std::array<Vec3, 12> corners;
  int size = 0;
};
ClippedPolygon clip_to_box(const LatticeTriangle& t, const LatticeBox& box);

}  // namespace kdm
