// SPDX-License-Identifier: MIT
// Finds what of an input its result does not come near.
#pragma once

#include "account/both_surfaces.h"

namespace kdm {

/// Returns what is lost, in model units.
LostArea find_lost_area(BothSurfaces& both);

}  // namespace kdm
