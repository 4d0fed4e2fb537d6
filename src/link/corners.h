// SPDX-License-Identifier: MIT
// Corners of the surface that the hits round them do not show.
#pragma once

#include "grid/grid_data.h"
#include "prepare/surface.h"

namespace kdm {

/// Fills the grid's corners. To be called when half-edges are linked and planes are still numbered
/// as the surface's triangles are. Linear in the surface's and the grid's size.
void keep_corners(const Surface& surface, GridData& grid);

}  // namespace kdm
