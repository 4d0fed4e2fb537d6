// SPDX-License-Identifier: MIT
// Chooses the model of inside and outside that suits a surface.
#pragma once

#include <memory>

#include "inside/inside_model.h"
#include "kdmanifold/build.h"
#include "prepare/surface.h"

namespace kdm {

/// Makes the model that suits the surface and the options: one for a sheet, one for a surface that
/// is to be repaired, and one that counts winding numbers for any other. `tolerance` is in lattice
/// units. The surface must outlive the model.
std::unique_ptr<InsideModel> make_inside_model(const Surface& surface, const BuildOptions& options,
                                               double tolerance);

}  // namespace kdm
