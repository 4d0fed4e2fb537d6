// SPDX-License-Identifier: MIT
// The construction of the cell tree and its hits (paper 5.1.1).
#pragma once

#include <memory>
#include <vector>

#include "construct/former_cells.h"
#include "grid/grid_data.h"
#include "inside/inside_model.h"
#include "kdmanifold/build.h"
#include "link/link_finest.h"
#include "prepare/surface.h"
#include "split/split_rules.h"

namespace kdm {

/// What construction returns beside the grid that it fills.
struct ConstructedCells {
  double tolerance;  ///< to which the cells were made, lattice units
  /// Per hit the triangle of the surface that makes it; kNone for hits that close a hole. The steps
  /// that link half-edges and find corners need it; the finished grid does not keep it.
  std::vector<TriangleId> triangle_of_hit;
  /// Only if the cells were made from the finest ones upwards (construct/bottom_up.h).
  std::unique_ptr<FinestGrid> finest;
};

/// Splits cells until the split rule that the options choose asks for no more splits, and fills the
/// cells, splitting edges, hits, planes and source faces of `grid`; half-edges are linked by a
/// later step. `model` says what is inside the surface. Grids of the same surface and options are
/// the same. Cells are made from the root down, or from the finest ones upwards where all are made
/// down to one depth and nothing is to be noted in `memory`; the grid is the same. `tolerance` is
/// in lattice units, and no cell is deeper than `depth`. The tolerance is widened, and the cells
/// are made anew, where a surface to be repaired would take more than a fixed budget of splits and
/// winding numbers (see Budget). Throws `kAborted` if `progress` says so.
///
/// `memory` may hold the cells of an earlier construction of the same grid with some solids in
/// other places, within the same lattice, tolerance and depth, and with the states of the same
/// model. Cells are taken over from there as far as they are the same.
ConstructedCells construct_cells(const Surface& surface, InsideModel& model,
                                 const BuildOptions& options, double tolerance, int depth,
                                 CellMemory memory, const Progress& progress, GridData& grid);

/// Does the same where a rule of the caller's splits cells, of a surface that needs no repair.
/// Returns `ConstructedCells::triangle_of_hit`.
std::vector<TriangleId> construct_cells_by(SplitRule& rule, const Surface& surface,
                                           InsideModel& model, const Progress& progress,
                                           GridData& grid);

}  // namespace kdm
