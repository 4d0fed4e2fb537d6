// SPDX-License-Identifier: MIT
// Flips edges where that takes creases away that the reference does not have.
#pragma once

#include "reduce/workpiece.h"

namespace kdm {

/// Flips edges at false creases (see SmoothTest), and their neighbours', as long as the worst turn
/// gets less, the triangles keep their shape, stay near to the reference and meet nothing. Needs a
/// kept distance. Returns how many edges were flipped.
Index flip_false_creases(Workpiece& piece);

}  // namespace kdm
