// SPDX-License-Identifier: MIT
// What of the input's planes a finished grid keeps.
#pragma once

#include "grid/grid_data.h"

namespace kdm {

/// Hits name planes by the input's faces until here. Drops those without hits and numbers the
/// others in the order in which the hits need them first. Linear in hits and faces.
void keep_used_planes(GridData& grid);

}  // namespace kdm
