// SPDX-License-Identifier: MIT
// Pairing half-edges of a surface that bounds no solid (paper 2.3.2).
#pragma once

#include <span>

#include "grid/grid_data.h"
#include "kdmanifold/build.h"
#include "prepare/surface.h"

namespace kdm {

/// Fills `opposite`, `start` and `rims` of the grid, whose first two have their size, and counts
/// ambiguous and guessed faces. Half-edges that find no partner stay on the boundary.
void link_sheet(const Surface& surface, std::span<const TriangleId> triangle_of_hit,
                Pairing pairing, GridData& grid);

}  // namespace kdm
