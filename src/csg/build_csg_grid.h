// SPDX-License-Identifier: MIT
// Builds the grid of several solids for a result that is to be reduced.
#pragma once

#include "kdmanifold/boolean.h"

namespace kdm {

/// The grid of an expression, and what it was built from.
struct SolidsGrid {
  Grid grid;
  /// The faces of all solids that the expression names, in model units, rounded to the lattice:
  /// also those that bound nothing. They do not depend on the order in which the solids were given.
  Mesh faces;
};

/// Does what `build_csg_grid` does, with cells that meet the surface within `share` (above 0, at
/// most 1) of the tolerance.
SolidsGrid build_csg_grid_within(const std::vector<Operand>& operands, const Expression& expression,
                                 const BuildOptions& options, double share,
                                 const Progress& progress);

}  // namespace kdm
