// SPDX-License-Identifier: MIT
// Makes and sorts the rim hits of a grid: the points where the rim of an open surface passes
// through minimal faces.
#pragma once

#include "grid/faces.h"
#include "prepare/surface.h"

namespace kdm {

/// Returns the rim hit for a point where the rim passes through the face. `side` is the triangle
/// side on the rim that crosses the face. The curve in which the surface meets the face runs from
/// this point to a hit, and `half_edge` is the half-edge of this hit that crosses the face.
RimHit rim_hit(const Surface& surface, const MinimalFace& face, HalfEdgeId half_edge, SideId side);

/// Sorts the grid's rim hits by half-edge, so that they can be found by binary search.
void sort_rims(GridData& grid);

}  // namespace kdm
