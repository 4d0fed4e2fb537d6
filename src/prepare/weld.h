// SPDX-License-Identifier: MIT
// Joining vertices of exactly equal position.
#pragma once

#include <vector>

#include "kdmanifold/mesh.h"

namespace kdm {

/// For every position the number of its distinct point, in order of first use.
struct Weld {
  std::vector<Index> point_of;  ///< one a position
  std::vector<Index> first_of;  ///< one a point: the first position that has it
};

/// Equal means equal coordinates (0 and -0 are). Linear time.
Weld weld_positions(const std::vector<Vec3>& positions);

}  // namespace kdm
