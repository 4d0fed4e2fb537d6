// SPDX-License-Identifier: MIT
// The steps from a prepared surface to its grid.
#pragma once

#include <memory>

#include "construct/exact_parts.h"
#include "construct/former_cells.h"
#include "grid/grid_data.h"
#include "inside/inside_model.h"
#include "kdmanifold/build.h"
#include "prepare/surface.h"

namespace kdm {

/// Returns the tolerance that the options ask for, in lattice units of the surface.
double lattice_tolerance(const Surface& surface, const BuildOptions& options);

/// Makes the grid of a surface: cells and hits, then the links of half-edges, corners and
/// statistics. `model` says what is inside; cells meet the surface within `tolerance`, in lattice
/// units. `exact` is what was taken out of the surface. Calls `progress` with 0.1 to 1. `memory` is
/// as in `construct_cells`.
std::unique_ptr<GridData> grid_of_surface(const Surface& surface, InsideModel& model,
                                          const BuildOptions& options, double tolerance,
                                          ExactParts exact, const Progress& progress,
                                          const CellMemory& memory = {});

}  // namespace kdm
