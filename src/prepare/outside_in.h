// SPDX-License-Identifier: MIT
// Finds how much of a closed surface bounds something, and how much is turned outside in by the
// rest of it.
#pragma once

#include <span>
#include <vector>

#include "mesh/numbers.h"
#include "prepare/sight.h"

namespace kdm {

/// Returns the share of the area of the `counted` triangles in front of which the winding number of
/// all triangles, which must form a closed surface, is negative. Such faces bound nothing: the
/// surface passes behind them, turned the same way. Looks at as many points as `samples`, 512 at
/// most, spread evenly by area and the same on every platform, with one ray each. `sight` must be
/// that of the triangles and points, which must be scaled to about 1.
double share_outside_in(std::span<const Triangle> triangles, const std::vector<Vec3>& points,
                        const Sight& sight, std::span<const TriangleId> counted, Index samples);

/// Returns the share of the area of the `counted` triangles that bounds something: the winding
/// number is above 0 behind them, but not in front of them. Triangles that lie on a counted one are
/// overlooked there; else as above.
double share_that_bounds(std::span<const Triangle> triangles, const std::vector<Vec3>& points,
                         const Sight& sight, std::span<const TriangleId> counted, Index samples);

}  // namespace kdm
