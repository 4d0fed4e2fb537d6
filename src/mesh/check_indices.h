// SPDX-License-Identifier: MIT
// Whether all faces name vertices that exist.
#pragma once

#include "kdmanifold/mesh.h"

namespace kdm {

/// Throws `kInvalidMesh` with the first face that does not.
void check_indices(const Mesh& mesh);

}  // namespace kdm
