// SPDX-License-Identifier: MIT
// Positions against needles, folds and triangles without area.
#pragma once

#include "extract/dual/dual_mesh.h"
#include "extract/dual/grid_view.h"

namespace kdm {

/// Vertices of neighbouring leaves may lie nearly together, where a crease passes between the
/// leaves, and a vertex may lie where a triangle is folded over. Moves such vertices within their
/// leaves, towards the middle of their hits or of their neighbours, where that leaves the triangles
/// round them better: no further from the planes than before or than half the
/// tolerance. The mesh has one triangle a hit. Vertices stay at corners, of their hits' planes or
/// kept by the grid, and on rims: with any rim in the grid nothing is moved. Returns the number of
/// moves.
Index move_off_slivers(const GridView& view, DualMesh& mesh);

/// Gives triangles that have no area in 32 bits some: moves corners along their edges, by half the
/// tolerance at a time at most. Nothing is done where 32 bits do not show that. Returns the number
/// of moves.
Index give_area(const GridView& view, DualMesh& mesh);

}  // namespace kdm
