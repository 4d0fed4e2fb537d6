// SPDX-License-Identifier: MIT
// What the recursion over cells makes.
#pragma once

#include <vector>

#include "grid/grid_data.h"
#include "inside/crossing.h"

namespace kdm {

/// Cells with the crossings on their splitting edges, numbered as those of a grid
/// (grid/grid_data.h). All crossings are kept; those that bound the solid become hits later.
struct MadeCells {
  std::vector<Cell> cells;  ///< without active sides
  EdgeCrossings crossings;
  std::vector<Vec3> unresolved;  ///< centres of leaves that did not pass the tests, in their order

  SplitId splits() const { return static_cast<SplitId>(cells.size() / 2); }
};

}  // namespace kdm
