// SPDX-License-Identifier: MIT
// From the dual mesh to the mesh that is handed out.
#pragma once

#include "extract/dual/dual_mesh.h"
#include "kdmanifold/mesh.h"

namespace kdm {

/// The mesh in model units, without dropped triangles and vertices. `quads`: two triangles beside a
/// strip become one quad. `single`: coordinates are rounded to 32 bits. `normals` are those of the
/// half-edges' corners, or none.
Mesh emit(const GridData& grid, const DualMesh& mesh, const std::vector<Vec3>& normals, bool quads,
          bool single);

}  // namespace kdm
