// SPDX-License-Identifier: MIT
// Joining the rims of cracks.
#pragma once

#include <vector>

#include "kdmanifold/types.h"

namespace kdm {

/// Joins the ends of sides without a neighbour that lie side by side, and returns how many pairs of
/// sides that were. Two belong together if each is the nearest to the other and their ends are no
/// further apart than `distance` (in the largest coordinate difference) and half the shorter one.
/// Joined corners take the lowest of their numbers and lie amid where they were; triangles may end
/// up with equal corners. n log n in the sides without a neighbour.
Index sew_rims(double distance, std::vector<Triangle>& triangles, std::vector<Vec3>& points);

}  // namespace kdm
