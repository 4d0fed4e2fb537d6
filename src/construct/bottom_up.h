// SPDX-License-Identifier: MIT
// The bottom-up construction of grids of one depth: from the finest cells to their tree, where the
// recursion of paper 5.1.1 goes from the root down. Both make the same grid.
#pragma once

#include <memory>
#include <vector>

#include "inside/inside_model.h"
#include "kdmanifold/build.h"
#include "kdmanifold/progress.h"
#include "link/link_finest.h"
#include "prepare/surface.h"

namespace kdm {

/// Tells whether cells can be made from the finest ones upwards: all must be halved in turn down to
/// one depth, for which a bit a cell can be kept, and states must follow from crossings alone.
/// Where holes were closed or several solids meet, cells are made from the root down.
bool suits_bottom_up(const Surface& surface, const InsideModel& model, const BuildOptions& options,
                     int depth);

/// Makes cells down to `depth`, and hits, as `construct_cells` does from the root down. Returns
/// what `link_finest` needs, and fills `triangle_of_hit`. Takes time linear in the triangles, in
/// the cells that they meet and in the grid lines; an octave of depths takes another bit a cell.
/// Throws `kAborted` if `progress` says so.
std::unique_ptr<FinestGrid> construct_bottom_up(const Surface& surface, InsideModel& model,
                                                int depth, const Progress& progress, GridData& grid,
                                                std::vector<TriangleId>& triangle_of_hit);

}  // namespace kdm
