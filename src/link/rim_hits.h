// SPDX-License-Identifier: MIT
// What a grid keeps of the rims of an open surface.
#pragma once

#include "grid/faces.h"
#include "prepare/surface.h"

namespace kdm {

/// Makes what the grid keeps where a rim passes through a minimal face: `side` is the triangle's
/// side on the rim, `half_edge` that of the hit at the other end of the surface's section with the
/// face.
RimHit rim_hit(const Surface& surface, const MinimalFace& face, HalfEdgeId half_edge, SideId side);

/// Sorts the grid's rim hits by half-edge, so that they can be found by binary search.
void sort_rims(GridData& grid);

}  // namespace kdm
