// SPDX-License-Identifier: MIT
// The hits round a minimal face, in cyclic order: which belong together by the surface's trace, how
// well two of them fit each other, and their links.
#pragma once

#include <span>
#include <vector>

#include "grid/faces.h"
#include "link/trace.h"

namespace kdm {

/// A hit on the outline of a face.
struct OutlineHit {
  Index half_edge;
  Index hit;
  int side;
  bool starts_below;
  bool ascending;  // the outline runs up the grid edge here
};

inline OutlineHit outline_hit(const GridData& grid, const FaceEdge& edge, Index hit, int side) {
  return {3 * hit + edge.slot, hit, side, starts_below(edge, grid.hits[hit].reversed()),
          side == 0 || side == 1};
}

/// Counter-clockwise.
inline void collect_outline(const GridData& grid, const MinimalFace& face,
                            std::vector<OutlineHit>& outline) {
  outline.clear();
  for_each_hit(face, [&](const FaceEdge& edge, Index hit, int side) {
    outline.push_back(outline_hit(grid, edge, hit, side));
  });
}

/// Do the half-edges run against each other, so that they may be linked?
inline bool compatible(const OutlineHit& a, const OutlineHit& b) {
  return a.starts_below != b.starts_below;
}

/// Links two half-edges across the face and notes where they start.
void link(const MinimalFace& face, const OutlineHit& a, const OutlineHit& b, GridData& grid);

/// The two long sides of a strip coincide: their hits are the same crossings and link one to one.
void link_strip(const MinimalFace& face, GridData& grid);

/// Walks along the surface's section with the face from each of its hits; `end` is kept where both
/// ends agree upon it and are compatible.
void trace_outline(const Surface& surface, std::span<const TriangleId> triangle_of_hit,
                   const MinimalFace& face, const std::vector<OutlineHit>& outline,
                   std::vector<Traced>& traced);

/// The surface's tangent line at a hit, on the face.
struct Tangent {
  double u, v;    // the hit's point on the face
  double nu, nv;  // unit normal of its tangent line there, or zero
};

void find_tangents(const GridData& grid, const MinimalFace& face,
                   const std::vector<OutlineHit>& outline, std::vector<Tangent>& tangents);

/// How far each of two hits lies from the other's tangent line, squared; a little of their
/// distance decides between pairings that fit equally well.
double deviation(const Tangent& a, const Tangent& b);

}  // namespace kdm
