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

/// Says beyond which sides of a box a mesh vertex lies: bit 2 * axis is set if it lies below the
/// low side, the next bit if it lies above the high side. 0: it is in the box.
using Outcode = std::uint8_t;
inline Outcode outcode(const LatticePoint& p, const LatticeBox& box) {
  unsigned code = 0;
  for (int i = 0; i < 3; ++i) {
    code |= (below_plane(p[i], box.lo[i]) ? 1u : 0u) << 2 * i;
    code |= (below_plane(p[i], box.hi[i]) ? 0u : 2u) << 2 * i;
  }
  return static_cast<Outcode>(code);
}
/// The outcodes of a triangle's corners.
using Outcodes = std::array<Outcode, 3>;
inline Outcodes outcodes(const LatticeTriangle& t, const LatticeBox& box) {
  return {outcode(t[0], box), outcode(t[1], box), outcode(t[2], box)};
}

/// Tells whether the mesh vertex is in the box.
inline bool vertex_in_box(const LatticePoint& p, const LatticeBox& box) {
  for (int i = 0; i < 3; ++i) {
    if (below_plane(p[i], box.lo[i]) || !below_plane(p[i], box.hi[i])) return false;
  }
  return true;
}

/// Tells whether the mesh edge from a to b meets the box, neither of whose ends is in it, and which
/// does not lie beyond one side with both.
bool long_edge_meets_box(const LatticePoint& a, const LatticePoint& b, const LatticeBox& box);
/// Tells whether the mesh edge from corner `i` of the triangle to the next one meets the box. The
/// outcodes must be those of the triangle.
inline bool edge_meets_box(const LatticeTriangle& t, const Outcodes& codes, int i,
                           const LatticeBox& box) {
  const int next = i == 2 ? 0 : i + 1;
  if (codes[i] == 0 || codes[next] == 0) return true;
  return (codes[i] & codes[next]) == 0 && long_edge_meets_box(t[i], t[next], box);
}
/// Tells whether the mesh edge from a to b meets the box.
inline bool edge_meets_box(const LatticePoint& a, const LatticePoint& b, const LatticeBox& box) {
  const Outcode code_a = outcode(a, box);
  const Outcode code_b = outcode(b, box);
  if (code_a == 0 || code_b == 0) return true;
  return (code_a & code_b) == 0 && long_edge_meets_box(a, b, box);
}

/// Tells whether the triangle meets the box, no corner of which is in it, and which does not lie
/// beyond one side with all of them.
bool wide_triangle_meets_box(const LatticeTriangle& t, const LatticeBox& box);
/// Tells whether the triangle meets the box. The outcodes must be those of the triangle.
inline bool triangle_meets_box(const LatticeTriangle& t, const Outcodes& codes,
                               const LatticeBox& box) {
  if (codes[0] == 0 || codes[1] == 0 || codes[2] == 0) return true;
  return (codes[0] & codes[1] & codes[2]) == 0 && wide_triangle_meets_box(t, box);
}
inline bool triangle_meets_box(const LatticeTriangle& t, const LatticeBox& box) {
  return triangle_meets_box(t, outcodes(t, box), box);
}

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
