// SPDX-License-Identifier: MIT
// Checks that all faces name vertices that exist.
#pragma once

#include "kdmanifold/mesh.h"

namespace kdm {

/// Throws `kInvalidMesh`, with the first face at fault, if a face names a vertex that the mesh does
/// not have.
void check_indices(const Mesh& mesh);

}  // namespace kdm
