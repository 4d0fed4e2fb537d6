// SPDX-License-Identifier: MIT
// Pairing half-edges across minimal faces (paper 2.1).
#pragma once

#include <span>

#include "grid/grid_data.h"
#include "kdmanifold/build.h"
#include "prepare/surface.h"

namespace kdm {

/// Fills `opposite` and `start` of the grid and counts ambiguous and guessed faces.
/// `triangle_of_hit` names the triangle of the surface that makes each hit, kNone for invented
/// ones.
void link_half_edges(const Surface& surface, std::span<const TriangleId> triangle_of_hit,
                     Pairing pairing, GridData& grid);

}  // namespace kdm
