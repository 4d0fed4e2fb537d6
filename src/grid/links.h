// SPDX-License-Identifier: MIT
// Links: the pairs of half-edges across minimal faces, made and changed here only.
//
// A link joins two half-edges that cross the same minimal face and run against each other: one
// leads from the leaf below the face to the leaf above it, the other one back. Which pairs of a
// face belong together is decided elsewhere (link/link.h); the pairs of a solid's face must not
// cross in the cyclic order of its hits, which these functions cannot check. The functions take
// constant time.
#pragma once

#include "geometry/assert.h"
#include "grid/faces.h"

namespace kdm {

/// Notes where a half-edge across the face starts. Must be done before it is linked.
inline void set_start(GridData& grid, HalfEdgeId half_edge, const MinimalFace& face,
                      bool starts_below) {
  grid.start[half_edge] =
      (starts_below ? face.below : face.above) | (face.strip() ? GridData::kStrip : 0);
}

/// Returns the leaf in which a half-edge ends. The starts of its hit's half-edges must be known.
inline CellId end_leaf(const GridData& grid, HalfEdgeId half_edge) {
  return grid.start_leaf(next_half_edge(half_edge, grid.hits[half_edge / 3].reversed()));
}

/// Returns whether two half-edges cross the same minimal face in opposite directions, so that they
/// may be linked. Two leaves have one minimal face in common at most. All starts must be known.
inline bool may_link(const GridData& grid, HalfEdgeId a, HalfEdgeId b) {
  return a != b && grid.start_leaf(a) == end_leaf(grid, b) &&
         grid.start_leaf(b) == end_leaf(grid, a) && grid.crosses_strip(a) == grid.crosses_strip(b);
}

/// Links two half-edges without links, whose starts are known.
inline void link(GridData& grid, HalfEdgeId a, HalfEdgeId b) {
  KDM_ASSERT(grid.opposite[a] == kNone && grid.opposite[b] == kNone, "links are mutual");
  KDM_ASSERT(grid.start_leaf(a) != grid.start_leaf(b), "linked half-edges run against each other");
  grid.opposite[a] = b;
  grid.opposite[b] = a;
}

/// Takes the link of a half-edge away, if it has one, also from the half-edge at its other end.
/// Returns that half-edge, or kNone.
inline HalfEdgeId unlink(GridData& grid, HalfEdgeId half_edge) {
  const HalfEdgeId partner = grid.opposite[half_edge];
  if (partner == kNone) return kNone;
  grid.opposite[half_edge] = kNone;
  grid.opposite[partner] = kNone;
  return partner;
}

/// Links `a` with `b` in place of the links that they have, and links the two half-edges that lose
/// their partners thereby with each other. All four cross one minimal face, and the new pairs run
/// against each other because the old ones did. Where only one of the two had a link (on a sheet),
/// its partner is left on the boundary. Changes nothing if `a` and `b` are linked already.
inline void relink(GridData& grid, HalfEdgeId a, HalfEdgeId b) {
  KDM_ASSERT(may_link(grid, a, b), "links of a face join its own hits");
  if (grid.opposite[a] == b) return;
  const HalfEdgeId partner_of_a = unlink(grid, a);
  const HalfEdgeId partner_of_b = unlink(grid, b);
  link(grid, a, b);
  if (partner_of_a != kNone && partner_of_b != kNone) link(grid, partner_of_a, partner_of_b);
}

}  // namespace kdm
