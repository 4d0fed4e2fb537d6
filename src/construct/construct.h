// SPDX-License-Identifier: MIT
// The top-down construction of the cell tree and its hits (paper 5.1.1).
#pragma once

#include "grid/grid_data.h"
#include "kdmanifold/build.h"
#include "prepare/surface.h"

namespace kdm {

/// Fills cells, splitting edges and hits of `grid`; links are another step. `tolerance` in lattice
/// units and `depth` are what the options come to for this surface. Returns the tolerance of the
/// cells: a wider one where a surface to be repaired would take beyond all measure.
double construct_cells(Surface& surface, const BuildOptions& options, double tolerance, int depth,
                       const Progress& progress, GridData& grid);

}  // namespace kdm
