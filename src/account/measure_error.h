// SPDX-License-Identifier: MIT
// Measures how far a result and its input are apart.
#pragma once

#include "account/both_surfaces.h"

namespace kdm {

/// Returns the deviations in model units.
MeshError measure_error(BothSurfaces& both);

}  // namespace kdm
