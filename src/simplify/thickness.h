// SPDX-License-Identifier: MIT
// Whether a region is thin: no ball of some diameter fits into it.
#pragma once

#include <array>
#include <vector>

#include "kdmanifold/types.h"

namespace kdm {

/// Tells whether no ball that is wider than `thickness` fits into a region. `boundary` is the
/// closed surfaces that bound it, turned outwards as seen from the region, in lattice units. What
/// lies between two parallel planes at this distance is thin; else boxes are cut smaller and
/// smaller, until all points of the region are known to be near enough to the boundary. Where that
/// takes too many boxes, as where the region is nearly as thick as that, it does not count as thin.
bool is_thin(const std::vector<std::array<Vec3, 3>>& boundary, double thickness);

}  // namespace kdm
