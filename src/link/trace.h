// SPDX-License-Identifier: MIT
// Following the input's surface across a minimal face, from hit to hit.
#pragma once

#include <span>

#include "geometry/predicates.h"
#include "prepare/surface.h"

namespace kdm {

/// A hit on the outline of a minimal face, as the trace needs it.
struct TraceEnd {
  Index triangle;
  int side;  ///< 0 to 3 as splitting edges are numbered
};

/// Where a trace arrives: at another end, at the rim of a sheet (a side without opposite), or
/// nowhere.
struct Traced {
  Index end = kNone;
  Index rim = kNone;
};

/// Walks from ends[start] through the triangles that cross the lattice plane `value` of `axis`
/// until one of them is another end's, or until the surface ends. Nowhere: the walk leaves the
/// rectangle (given by its corners, on the axes after `axis`) without meeting an end: the surface
/// there was dropped by the inside rule. On embedded input every walk arrives.
Traced trace(const Surface& surface, int axis, std::int32_t value,
             const std::array<std::int32_t, 2>& lo, const std::array<std::int32_t, 2>& hi,
             std::span<const TraceEnd> ends, Index start);

}  // namespace kdm
