// SPDX-License-Identifier: MIT
// Follows the input's surface across a minimal face, from hit to hit.
#pragma once

#include <span>

#include "geometry/predicates.h"
#include "link/outline.h"
#include "prepare/surface.h"

namespace kdm {

/// A hit on the outline of a rectangle, from which a trace starts or at which it arrives.
struct TraceEnd {
  TriangleId triangle;  ///< the one that makes the hit; kNone if the hit is invented
  int side;             ///< of the rectangle, 0 to 3 as splitting edges are numbered
};

/// Where a trace arrives: at another end, at the rim of an open surface, or, if both are kNone,
/// nowhere.
struct Traced {
  Index end = kNone;   ///< its place among the ends
  SideId rim = kNone;  ///< a triangle's side beyond which there is no other triangle
};

/// Walks from ends[start] through the triangles that cross the lattice plane at `value` along
/// `axis`, until it comes to the triangle of another end, or to a rim of the surface. The rectangle
/// on that plane is given by its corners' coordinates on the two axes after `axis`. If the input
/// does not cross itself, every walk arrives. Otherwise a walk may leave the rectangle at a
/// crossing that the inside rule did not make a hit of.
Traced trace(const Surface& surface, int axis, std::int32_t value,
             const std::array<std::int32_t, 2>& lo, const std::array<std::int32_t, 2>& hi,
             std::span<const TraceEnd> ends, Index start);

/// Traces from each hit of a face's outline. `end` of a result is a place in the outline; it is set
/// only where the traces from both hits arrive at each other and the hits' half-edges are
/// `compatible`.
void trace_outline(const Surface& surface, std::span<const TriangleId> triangle_of_hit,
                   const MinimalFace& face, const std::vector<OutlineHit>& outline,
                   std::vector<Traced>& traced);

}  // namespace kdm
