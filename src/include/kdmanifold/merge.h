// SPDX-License-Identifier: MIT
// Merges two grids whose meshes are gone (the future work of the paper's section 7).
#pragma once

#include "kdmanifold/expression.h"
#include "kdmanifold/grid.h"
#include "kdmanifold/progress.h"

namespace kdm {

/// Makes the grid of what an expression says of the solids of two grids, which it names 0 and 1:
/// `union_of(0, 1)`, `intersection(0, 1)`, `difference(0, 1)`, `symmetric_difference(0, 1)`. Built,
/// merged, simplified and loaded grids serve alike; their meshes are not needed. Both must have the
/// same lattice: build them with the same `BuildOptions::box`. They stay as they are.
///
/// Where one solid alone has surface, its cells, hits and links are taken over as they are. Where
/// both have, cells are split as both grids have them split, and further, until the tolerance is
/// met; a leaf is also cut by a plane of the other grid that cannot be avoided. Then the hits on
/// edges that the grid has had stay, and new edges are cut with the surface that the grid spans by
/// itself: through its hits, through a point of the minimal face for each link, and through the
/// vertices that extraction gives its loops. New hits have the plane of the old hit that spans the
/// surface there, as far as this lies in that plane.
///
/// What holds: the result is a valid grid, and extraction makes a closed 2-manifold of it. A new
/// hit lies on the spanned surface, within a lattice unit or two; that surface is as far from what
/// the grid was built from as its hits, links' points and vertices are, which is the grid's
/// tolerance where the grid has one vertex for each feature. The wider of both tolerances holds for
/// the result. What does not: where both solids have surface in a cell, its topology is not
/// certified (`GridStats::topology_resolved` is false), and surfaces that lie on each other, or
/// nearer than the tolerance, may leave slivers and gaps thinner than the tolerance. A grid that is
/// merged with itself leaves none. The order of the grids may make a difference to the cells.
///
/// The result's `operands` are those of both grids, of which one that was built from a mesh counts
/// as one. The time grows with hits times depth.
///
/// Throws `kInvalidOption` for sheets, for grids of different lattices, for an expression that
/// names other operands or holds for points far away, and where a thin part that one grid keeps
/// without cells (`GridStats::exact_parts`) meets surface of the other; `kEmptyResult` if nothing
/// is left; `kAborted` and `kOutOfMemory`.
Grid merge_grids(const Grid& first, const Grid& second, const Expression& expression,
                 const Progress& progress = {});

}  // namespace kdm
