// SPDX-License-Identifier: MIT
// Moves vertices so that no triangle is without area.
#pragma once

#include "extract/dual/dual_mesh.h"
#include "extract/dual/grid_view.h"

namespace kdm {

/// Gives area to triangles that have none once coordinates are rounded to 32 bits: moves a vertex
/// of each along an edge, by half the grid's tolerance at a time at most. Some triangles may stay
/// without area; all do where the model is so far from the origin that 32 bits do not show half the
/// tolerance. Returns the number of moves.
Index give_area(const GridView& view, DualMesh& mesh);

}  // namespace kdm
