// SPDX-License-Identifier: MIT
// Welds vertices of exactly equal position.
#pragma once

#include <vector>

#include "mesh/numbers.h"

namespace kdm {

/// Which vertices have the same position and so become one point. Points are numbered in the order
/// of their first vertices.
struct Weld {
  std::vector<PointId> point_of;  ///< per vertex: its point
  std::vector<Index> first_of;    ///< per point: its first vertex
};

/// Finds vertices of equal position. Positions are equal if their coordinates are (0 equals -0).
/// Takes linear time.
Weld weld_positions(const std::vector<Vec3>& positions);

}  // namespace kdm
