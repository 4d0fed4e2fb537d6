// SPDX-License-Identifier: MIT
// Flips edges of triangles that are folded over their neighbours, or thin.
#pragma once

#include "extract/dual/edit_log.h"
#include "extract/dual/embed_level.h"
#include "extract/dual/grid_view.h"
#include "extract/dual/scope.h"

namespace kdm {

/// Flips edges of triangles that are turned away from the plane of their hit, or have no area,
/// where the two triangles at the edge lie better after the flip. Such folds, which reach beyond
/// the surface, come about where leaves of different size lie beside a concave crease. Also flips
/// edges of thin triangles, such as three vertices in a row along a crease make, where the smallest
/// angle becomes twice as wide. No flip makes a second edge between two vertices, so an index mesh
/// that is 2-manifold stays so. Triangles of hits above level `kTriangle` are left alone. Looks at
/// all triangles, or only at the triangles in a list. Returns the number of flips.
Index unfold(const GridView& view, const EmbedLevels& levels, DualMesh& mesh, EditLog& log,
             const Scope& triangles = {});

}  // namespace kdm
