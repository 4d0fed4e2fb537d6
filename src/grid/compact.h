// SPDX-License-Identifier: MIT
// Removes splits from a grid in place, and then numbers the grid consecutively again.
//
// Splits are removed one by one, without moving anything in the arrays: the cell becomes a leaf,
// its two children and its four splitting edges with all their hits are dead from then on, and
// every other edge keeps its hits under their numbers. While splits are removed,
// - half-edges may still start in dead cells by `start`: such a half-edge starts in the leaf that
//   is the dead cell's living ancestor, which a union-find over the cells finds;
// - planes may be appended in any order and lose their last hits;
// - the numbers of cells and splits have holes, and sides without hits may be marked active.
// So of the invariants in src/README.md, "no cell is lost", "planes come in the order of their
// first hits" and whatever rests on them hold again only after `compact`.
#pragma once

#include "grid/grid_data.h"
#include "mesh/disjoint_sets.h"
#include "mesh/marks.h"

namespace kdm {

/// Makes a leaf of `cell`, whose two children must be leaves, and joins it with them in
/// `merged_cells`, where `find` gives a dead cell's living ancestor (it has the lowest number).
/// Links must be changed by the caller: before `compact`, no half-edge of a living hit may be
/// linked to one of the four splitting edges, and no link may pass between the two children; where
/// the four edges have no hits, there is no such link. Takes constant time.
void remove_split(GridData& grid, CellId cell, DisjointSets& merged_cells);

/// Numbers everything that lives consecutively, in the order that it has: splits, cells, splitting
/// edges, hits, half-edges with `opposite` and `start`, rims and corners; planes in the order of
/// their first hits, without those that no hit needs. Drops the rims and corners of dead hits. Sets
/// the active sides and the statistics that can be counted (cells, leaves, depth, hits, invented
/// hits, ambiguous faces, bytes); what the construction reported stays. `merged_cells` is what
/// `remove_split` was given; it may be used no longer. Changes nothing of a built grid. Linear time
/// and, beyond the grid, some bytes a cell and a hit.
void compact(GridData& grid, DisjointSets& merged_cells);

/// Removes the marked hits from a grid, and numbers it consecutively again, with its planes, rims
/// and corners. No link may lead from a hit that goes to one that stays, and of hits that follow
/// each other on an edge, or round a minimal face, those on both sides of the same stretch of
/// material, or of void, must go. Cells stay. Linear time.
void remove_hits(GridData& grid, const Marks& gone);

/// Does the same to a grid from which no splits were removed; only planes can then be out of order.
void compact(GridData& grid);

}  // namespace kdm
