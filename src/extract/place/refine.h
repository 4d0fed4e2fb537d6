// SPDX-License-Identifier: MIT
// Adds vertices at hits and links, where one triangle for each hit is too few.
#pragma once

#include "extract/dual/edit_log.h"
#include "extract/dual/embed_level.h"
#include "extract/dual/grid_view.h"
#include "extract/dual/scope.h"

namespace kdm {

/// Adds the vertices that the levels prescribe (see embed_level.h), and one in each minimal face
/// that an edge of the mesh crosses further than `distance` (lattice units) from the surface. Looks
/// at all hits and their links, or at those of an ascending list, whose triangles are not divided
/// yet. Returns the number of vertices added.
Index refine(const GridView& view, const EmbedLevels& levels, double distance, DualMesh& mesh,
             EditLog& log, const Scope& hits = {});

}  // namespace kdm
