// SPDX-License-Identifier: MIT
// Checks the invariants of a grid.
#pragma once

#include "grid/grid_data.h"

namespace kdm {

/// Checks every rule of the list in src/README.md and throws an Error of code `kInternal` that
/// names the first broken one. The grid may hold any numbers whatever: each rule reads only what
/// the rules before it have shown to be safe to read. Takes time linear in cells and hits for grids
/// that construction made.
void validate(const GridData& grid);

}  // namespace kdm
