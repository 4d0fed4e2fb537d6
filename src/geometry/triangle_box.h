// SPDX-License-Identifier: MIT
// Tells exactly which mesh elements meet which boxes, under the perturbation of predicates.h.
//
// Two convex sets are disjoint iff one of finitely many planes separates them. Such a plane is
// normal to an axis, or contains the triangle, or contains an edge of the triangle and is parallel
// to an axis: seen along this axis, all corners of the box then lie on one side of the edge. So
// every test is one of the signs of predicates.h. A box may be flat (lo == hi on one axis): then it
// is a rectangle in a lattice plane. Boxes and triangles count without their boundaries.
#pragma once

#include "geometry/predicates.h"

namespace kdm {

/// Tells whether the mesh vertex is in the box.
inline bool vertex_in_box(const LatticePoint& p, const LatticeBox& box) {
  for (int i = 0; i < 3; ++i) {
    if (below_plane(p[i], box.lo[i]) || !below_plane(p[i], box.hi[i])) return false;
  }
  return true;
}
/// Tells whether the mesh edge from a to b meets the box.
bool edge_meets_box(const LatticePoint& a, const LatticePoint& b, const LatticeBox& box);
/// Tells whether the triangle meets the box.
bool triangle_meets_box(const LatticeTriangle& t, const LatticeBox& box);

/// The part of a triangle that lies within a box, with rounded corners in lattice units. It has
/// nine corners at most, since each of the six sides of the box adds at most one to the three of
/// the triangle; there is room for three more.
struct ClippedPolygon {
  std::array<Vec3, 12> corners;
  int size = 0;
};

/// Cuts off what lies outside the box.
ClippedPolygon clip_to_box(const LatticeTriangle& t, const LatticeBox& box);

}  // namespace kdm
