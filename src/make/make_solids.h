// SPDX-License-Identifier: MIT
// Makes the meshes of Boolean operations, once or again and again.
#pragma once

#include "csg/solids_builder.h"
#include "kdmanifold/boolean.h"

namespace kdm {

/// Throws `kInvalidOption` if the options are none for several solids.
void check_for_solids(const MakeOptions& options);

/// Does what `make_solids_in_steps` does with the operands and the expression of a builder, whose
/// options are `options.build`.
MadeManifold make_solids(SolidsBuilder& builder, const MakeOptions& options,
                         const StepProgress& progress);

}  // namespace kdm
