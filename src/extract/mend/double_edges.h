// SPDX-License-Identifier: MIT
// Turns a mesh of manifold half-edges into one that is manifold also as an index mesh, whose edges
// are known by their two vertices only.
#pragma once

#include "extract/dual/edit_log.h"
#include "extract/dual/grid_view.h"
#include "extract/dual/scope.h"

namespace kdm {

/// Separates edges that join the same two vertices: all but one of them get a vertex of their own,
/// near the hits on both sides, and their two triangles are divided there. Looks at the edges of
/// all vertices or of a list; which of several edges stays whole may depend on the list. Returns
/// the number of vertices inserted.
Index separate_double_edges(const GridView& view, DualMesh& mesh, EditLog& log,
                            const Scope& vertices = {});

}  // namespace kdm
