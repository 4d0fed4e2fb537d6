// SPDX-License-Identifier: MIT
// Vertices at hits and links, where one triangle a hit is too few.
#pragma once

#include "extract/dual/embed_level.h"
#include "extract/dual/grid_view.h"

namespace kdm {

/// Adds the vertices that the levels ask for, and one in each minimal face that an edge of the
/// mesh crosses further than `distance` (lattice units) from the surface. Returns their number.
/// Looks at all hits and their links or at those of `hits`, which ascend and are not divided yet.
Index refine(const GridView& view, const EmbedLevels& levels, double distance, DualMesh& mesh,
             const std::vector<Index>* hits = nullptr);

}  // namespace kdm
