// SPDX-License-Identifier: MIT
// From manifold half-edges to a manifold index mesh.
#pragma once

#include "extract/dual/edit_log.h"
#include "extract/dual/grid_view.h"
#include "extract/dual/scope.h"

namespace kdm {

/// Separates edges that join the same two vertices: all but one of them get a vertex of their own,
/// near the hits on both sides, and their two triangles are divided there. Looks at the edges of
/// all vertices or of a list; which edge of several stays whole may depend on that. Returns the
/// number of vertices inserted.
Index separate_double_edges(const GridView& view, DualMesh& mesh, EditLog& log,
                            const Scope& vertices = {});

}  // namespace kdm
