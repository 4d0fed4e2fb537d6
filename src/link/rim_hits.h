// SPDX-License-Identifier: MIT
// What a grid keeps of the rims that cut the links of its half-edges off.
#pragma once

#include "grid/faces.h"
#include "prepare/surface.h"

namespace kdm {

/// What the grid keeps of a rim side that leaves the face at the link of this half-edge.
RimHit rim_hit(const Surface& surface, const MinimalFace& face, Index half_edge, Index side);

/// Sorts the grid's rim hits by half-edge, as look-ups want them.
void sort_rims(GridData& grid);

}  // namespace kdm
