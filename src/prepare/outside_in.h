// SPDX-License-Identifier: MIT
// Finds how much of a closed surface is turned outside in by the rest of it.
#pragma once

#include <span>
#include <vector>

#include "mesh/numbers.h"

namespace kdm {

/// Returns the share of the area of the first `counted` triangles in front of which the winding
/// number of all triangles, which must form a closed surface, is negative. Such faces bound
/// nothing: the surface passes behind them, turned the same way. Looks at 128 points, spread evenly
/// by area and the same on every platform, with one ray each. `points` must be scaled to about 1.
double share_outside_in(std::span<const Triangle> triangles, Index counted,
                        const std::vector<Vec3>& points);

}  // namespace kdm
