// SPDX-License-Identifier: MIT
// Pairing half-edges across minimal faces (paper 2.1).
#pragma once

#include "grid/grid_data.h"
#include "kdmanifold/build.h"
#include "prepare/surface.h"

namespace kdm {

/// Fills `opposite` and `start` of the grid and counts ambiguous and guessed faces.
void link_half_edges(const Surface& surface, Pairing pairing, GridData& grid);

}  // namespace kdm
