// SPDX-License-Identifier: MIT
// Whether coordinates can be computed with.
#pragma once

#include "kdmanifold/mesh.h"

namespace kdm {

/// Throws `kInvalidMesh` with the first coordinate that is not finite or beyond 1e150.
void check_positions(const Mesh& mesh);

}  // namespace kdm
