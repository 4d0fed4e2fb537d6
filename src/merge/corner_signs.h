// SPDX-License-Identifier: MIT
// Which corners of a grid's cells are inside the solid.
#pragma once

#include <cstdint>
#include <vector>

#include "grid/grid_data.h"

namespace kdm {

/// Returns for each cell of a solid's grid eight bits, one a corner: that bit is set whose number
/// has 1 for x, 2 for y and 4 for z at the high end, if the corner is inside. Follows from the hits
/// alone (paper 5.2). Takes time linear in cells, but for long edges.
std::vector<std::uint8_t> corner_signs(const GridData& grid);

}  // namespace kdm
