// SPDX-License-Identifier: MIT
// From the dual mesh to the mesh that is handed out.
#pragma once

#include "extract/dual/dual_mesh.h"
#include "kdmanifold/mesh.h"

namespace kdm {

/// Returns the mesh in model units, without dropped triangles and vertices. With `quads` two
/// triangles beside a strip become one quad, with `single` coordinates are rounded to 32 bits.
/// `normals` are those of the corners where the half-edges start, or empty.
Mesh emit(const GridData& grid, const DualMesh& mesh, const std::vector<Vec3>& normals, bool quads,
          bool single);

}  // namespace kdm
