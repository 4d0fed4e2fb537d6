// SPDX-License-Identifier: MIT
// Counts the statistics that follow from the grid alone.
#pragma once

#include "grid/grid_data.h"

namespace kdm {

/// Counts cells, leaves, depth, hits, hits of no input face and bytes, and notes the tolerance
/// (model units) and whether the grid is a sheet's. Leaves the other statistics as they are. Linear
/// in cells and hits.
void count_stats(GridData& grid);

/// Counts the minimal faces whose links do not follow from their hits: faces with more than two
/// hits, except strips.
Index count_ambiguous_faces(const GridData& grid);

}  // namespace kdm
