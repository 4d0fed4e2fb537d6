// SPDX-License-Identifier: MIT
// Triangles that are folded over their neighbours, or thin.
#pragma once

#include "extract/dual/edit_log.h"
#include "extract/dual/embed_level.h"
#include "extract/dual/grid_view.h"
#include "extract/dual/scope.h"

namespace kdm {

/// Flips edges of triangles that are turned away from the plane of their hit, or have no area,
/// where the two triangles then lie better: leaves of different size beside a concave crease leave
/// such folds, which reach beyond the surface. The same where the smallest angle of thin triangles
/// becomes twice as wide, as of three vertices in a row along a crease. No edge is doubled by it,
/// so an index mesh that is 2-manifold stays so. Triangles of hits above level `kTriangle` are left
/// alone. Looks among all triangles or those of a list. Returns the number of flips.
Index unfold(const GridView& view, const EmbedLevels& levels, DualMesh& mesh, EditLog& log,
             const Scope& triangles = {});

}  // namespace kdm
