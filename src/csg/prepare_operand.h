// SPDX-License-Identifier: MIT
// Makes a solid of an operand, whatever its mesh is like.
#pragma once

#include "kdmanifold/boolean.h"
#include "prepare/joined_solids.h"

namespace kdm {

/// Transforms an operand and prepares its faces as `build_grid` does. A surface that neither sewing
/// nor patches close is built and extracted by itself, at half the tolerance; then the faces are
/// those of the result. Throws what `build_grid` throws, and `kInvalidMesh` for a transform that is
/// not finite or not invertible; the messages begin with the number of the operand.
SolidFaces prepare_operand(const Operand& operand, Index number, const BuildOptions& options,
                           const Progress& progress);

}  // namespace kdm
