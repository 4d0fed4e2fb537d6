// SPDX-License-Identifier: MIT
// How much of a closed surface is the side of a thin wall.
#pragma once

#include <span>
#include <vector>

#include "kdmanifold/types.h"

namespace kdm {

/// Estimates which share of a surface's area has an opposite side within four times `tolerance`,
/// straight behind it. Looks at 64 places, spread by area, in one pass over the triangles.
double share_of_walls(std::span<const Triangle> triangles, const std::vector<Vec3>& points,
                      double tolerance);

}  // namespace kdm
