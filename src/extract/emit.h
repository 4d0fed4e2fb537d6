// SPDX-License-Identifier: MIT
// Turns the dual mesh into the mesh that extraction returns.
#pragma once

#include "extract/dual/dual_mesh.h"
#include "kdmanifold/mesh.h"

namespace kdm {

/// Returns the mesh in model units, without dropped triangles and vertices. With `quads` two
/// triangles beside a strip become one quad, with `single` coordinates are rounded to 32 bits.
/// `normals` holds for each half-edge the normal at the corner where it starts, or is empty.
Mesh emit(const GridData& grid, const DualMesh& mesh, const std::vector<Vec3>& normals, bool quads,
          bool single);

}  // namespace kdm
