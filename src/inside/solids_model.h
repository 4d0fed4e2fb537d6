// SPDX-License-Identifier: MIT
// The inside model of Boolean operations: each solid has a winding number of its own.
#pragma once

#include <memory>

#include "inside/inside_model.h"
#include "inside/solid_states.h"
#include "prepare/surface.h"

namespace kdm {

/// Makes the model of several solids, which `surface.solid_of` tells apart. `tolerance` is in
/// lattice units. The surface and the states must outlive the model.
std::unique_ptr<InsideModel> make_solids_model(const Surface& surface, SolidStates& states,
                                               double tolerance);

}  // namespace kdm
