// SPDX-License-Identifier: MIT
// Checks that coordinates can be computed with.
#pragma once

#include "kdmanifold/mesh.h"

namespace kdm {

/// Throws `kInvalidMesh`, with the first coordinate at fault, if one is not finite or its absolute
/// value is above 1e150.
void check_positions(const Mesh& mesh);

}  // namespace kdm
