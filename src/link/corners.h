// SPDX-License-Identifier: MIT
// Finds corners of the surface that cannot be found from the planes of the hits round them.
#pragma once

#include <span>

#include "grid/grid_data.h"
#include "prepare/surface.h"

namespace kdm {

/// Fills `corners` of a grid whose half-edges are linked. `triangle_of_hit` names the triangle of
/// the surface that makes each hit, kNone for invented ones. Takes time linear in the surface's and
/// the grid's size.
void keep_corners(const Surface& surface, std::span<const TriangleId> triangle_of_hit,
                  GridData& grid);

}  // namespace kdm
