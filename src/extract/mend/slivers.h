// SPDX-License-Identifier: MIT
// Moves vertices so that there are fewer needles and folds.
#pragma once

#include "extract/dual/dual_mesh.h"
#include "extract/dual/grid_view.h"

namespace kdm {

/// Moves vertices of needles and of folded triangles within their leaves, towards the middle of
/// their hits or of their neighbours, where that makes the smallest angle round them twice as wide
/// or unfolds a triangle. Needles come about where a crease passes between two leaves whose
/// vertices then lie nearly together. A moved vertex is no further from its hits' planes than it
/// was before, or else within half the grid's tolerance of them. Vertices stay where their hits'
/// planes meet in a corner, at corners that the grid keeps, and on the boundary; in a grid with
/// rims all stay. The mesh must have one triangle for each hit. Returns the number of moves.
Index move_off_slivers(const GridView& view, DualMesh& mesh);

}  // namespace kdm
