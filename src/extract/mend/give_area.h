// SPDX-License-Identifier: MIT
// Triangles without area.
#pragma once

#include "extract/dual/dual_mesh.h"
#include "extract/dual/grid_view.h"

namespace kdm {

/// Moves vertices of triangles that have no area once coordinates are rounded to 32 bits, each
/// along an edge by half the grid's tolerance at a time at most, so that the triangles have some.
/// Some may stay as they are; all do where the model is so far from the origin that 32 bits do not
/// show half the tolerance. Returns the number of moves.
Index give_area(const GridView& view, DualMesh& mesh);

}  // namespace kdm
