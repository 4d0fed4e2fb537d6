// SPDX-License-Identifier: MIT
// A grid while splits are removed from it, with its surface: loops, where their vertices are, and
// what vertices and hits stand for.
#pragma once

#include <vector>

#include "geometry/quadric.h"
#include "grid/compact.h"
#include "mesh/marks.h"
#include "mesh/numbers.h"
#include "simplify/dual_quadric.h"

namespace kdm {

/// The grid as `compact.h` describes it between removals; nothing in it changes its number. Loops
/// that become one go on under the lowest of their numbers.
struct WorkGrid {
  explicit WorkGrid(const GridData& data);

  GridData grid;
  DisjointSets merged_cells;
  std::vector<LatticeBox> boxes;      ///< per cell, dead or not
  std::vector<CellId> parent;         ///< per cell; kNone for the root
  std::vector<CellId> cell_of_split;  ///< also of removed splits
  std::vector<SplitId> split_of_hit;  ///< the split on whose edge it lies
  std::vector<LoopId> loop;           ///< per half-edge: the loop in whose vertex it starts
  std::vector<CellId> leaf;           ///< per loop: its leaf before the first removal
  std::vector<Vec3> position;         ///< per loop: its vertex, lattice coordinates
  std::vector<PrimalQuadric> planes;  ///< per loop: of all hits that its vertex stands for
  std::vector<DualQuadric> points;    ///< per hit: of all hits that it stands for
  Marks ring_changed;                 ///< per loop: its ring has lost hits, or it has a corner
  Marks joined;                       ///< per loop: it was several
  Marks split;                        ///< per loop: its vertex is split by `extract`
  Marks relinked;                     ///< per half-edge

  HalfEdgeId next(HalfEdgeId h) const { return next_half_edge(h, grid.hits[h / 3].reversed()); }
  /// Returns the half-edge after, or before, this one round the vertex in which it starts; kNone
  /// beyond the boundary.
  HalfEdgeId next_in_ring(HalfEdgeId h) const {
    return grid.opposite[h] == kNone ? kNone : next(grid.opposite[h]);
  }
  HalfEdgeId previous_in_ring(HalfEdgeId h) const { return grid.opposite[next(next(h))]; }

  /// Returns the half-edge of a hit that starts in the lower child of its split, in the upper one,
  /// and in the leaf beyond the side plane.
  HalfEdgeId from_below(HitId h) const { return 3 * h + (grid.hits[h].reversed() ? 1 : 0); }
  HalfEdgeId from_above(HitId h) const { return 3 * h + (grid.hits[h].reversed() ? 0 : 2); }
  HalfEdgeId from_beyond(HitId h) const { return 3 * h + (grid.hits[h].reversed() ? 2 : 1); }

  /// Tells whether the split of the cell is between leaves, so that it may be removed.
  bool is_minimal(CellId cell) const {
    const Cell& c = grid.cells[cell];
    return !c.leaf() && grid.cells[c.below()].leaf() && grid.cells[c.above()].leaf();
  }

  /// Returns the corners of a hit's triangle in turn.
  std::array<Vec3, 3> corners(HitId h) const {
    const HalfEdgeId second = next(3 * h);
    return {position[loop[3 * h]], position[loop[second]], position[loop[next(second)]]};
  }

  /// Returns the grid as it has become, numbered consecutively: the vertices of the loops that were
  /// touched are kept as corners. `moved` is how far, in model units, the surface may be from what
  /// it was at first.
  GridData result(double moved) const;
};

}  // namespace kdm
