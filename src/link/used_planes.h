// SPDX-License-Identifier: MIT
// What of the input's planes a finished grid keeps.
#pragma once

#include "grid/grid_data.h"
#include "prepare/surface.h"

namespace kdm {

/// Until here hits name planes by the input's faces, and these face as the input does. Drops planes
/// without hits, numbers the others in the order in which the hits need them first, and turns them
/// out of the solid: a face that the inside rule makes a cavity's, or solid on both sides, gets the
/// opposite plane where hits ask for it, and both if they ask for both. Linear in hits and faces.
void keep_used_planes(const Surface& surface, GridData& grid);

}  // namespace kdm
