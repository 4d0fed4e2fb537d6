// SPDX-License-Identifier: MIT
// Adds vertices at hits and links, where one triangle for each hit is too few.
#pragma once

#include <span>

#include "extract/dual/edit.h"
#include "extract/dual/edit_log.h"
#include "extract/dual/embed_level.h"
#include "extract/dual/grid_view.h"
#include "extract/dual/scope.h"

namespace kdm {

/// Adds the vertices that the levels prescribe (see embed_level.h), and one in each minimal face
/// that an edge of the mesh crosses further than `distance` (lattice units) from the surface. Looks
/// at all hits and their links, or at those of an ascending list, whose triangles are not divided
/// yet. Divides these also at `one_sided` vertices, which hits that are not listed have on links to
/// them; ascending by `half_edge`. Returns the number of vertices added.
Index refine(const GridView& view, const EmbedLevels& levels, double distance, DualMesh& mesh,
             EditLog& log, const Scope& hits = {}, std::span<const OneSidedVertex> one_sided = {});

}  // namespace kdm
