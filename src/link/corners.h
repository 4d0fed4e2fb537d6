// SPDX-License-Identifier: MIT
// Finding corners of the surface that the hits round them do not show.
#pragma once

#include <span>

#include "grid/grid_data.h"
#include "prepare/surface.h"

namespace kdm {

/// Fills the corners of a grid whose half-edges are linked. `triangle_of_hit` names the triangle of
/// the surface that makes each hit, kNone for invented ones. Takes time linear in the surface's and
/// the grid's size.
void keep_corners(const Surface& surface, std::span<const TriangleId> triangle_of_hit,
                  GridData& grid);

}  // namespace kdm
