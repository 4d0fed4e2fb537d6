// SPDX-License-Identifier: MIT
// From manifold half-edges to a manifold index mesh.
#pragma once

#include "extract/dual/dual_mesh.h"
#include "extract/dual/grid_view.h"

namespace kdm {

/// Where several pairs of half-edges join the same two vertices, all but the first get a vertex
/// of their own, near the hits on both sides, and their two triangles are divided there.
/// Returns the number of vertices inserted. Looks at the edges of all vertices or of `vertices`.
Index separate_double_edges(const GridView& view, DualMesh& mesh,
                            const std::vector<Index>* vertices = nullptr);

}  // namespace kdm
