// SPDX-License-Identifier: MIT
// Every invariant of a grid, checked.
#pragma once

#include "grid/grid_data.h"

namespace kdm {

/// Throws `kInternal` naming the first broken rule of src/README.md's list. Linear in the grid.
void validate(const GridData& grid);

}  // namespace kdm
