// SPDX-License-Identifier: MIT
// Checking the invariants of a grid.
#pragma once

#include "grid/grid_data.h"

namespace kdm {

/// Checks every rule of the list in src/README.md and throws an Error of code `kInternal` that
/// names the first broken one. May be given anything: a rule reads only what those before it have
/// made safe. Linear in cells and hits for grids that are built.
void validate(const GridData& grid);

}  // namespace kdm
