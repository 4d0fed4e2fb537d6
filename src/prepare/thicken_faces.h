// SPDX-License-Identifier: MIT
// Gives some faces of an input a thickness.
#pragma once

#include "mesh/marks.h"
#include "prepare/faces.h"

namespace kdm {

/// Puts a shell of this thickness, in model units, in place of the wanted faces (see `thicken`).
/// No wanted face may have a face as neighbour, by the topology, that is not wanted. There must be
/// no patches. Where a wanted face meets others along an edge, its shell reaches into them. The
/// topology becomes invalid.
void thicken_faces(InputFaces& faces, const Marks& wanted, double thickness);

}  // namespace kdm
