// SPDX-License-Identifier: MIT
// Flips edges, and moves vertices, where that takes creases away that the reference does not have.
#pragma once

#include "reduce/workpiece.h"

namespace kdm {

/// Adds to the true creases those of the mesh at which the reference turns without an edge: where
/// its parts pass through each other. Needs a kept distance, and a mesh as it was given.
void find_crossing_creases(Workpiece& piece);

/// Flips edges at false creases (see SmoothTest), and their neighbours', as long as the worst turn
/// gets less, the triangles keep their shape, stay near to the reference and meet nothing. Where no
/// flip helps, moves one of the vertices (see vertex_moves.h). Needs a kept distance. Returns how
/// many edges were flipped.
Index flip_false_creases(Workpiece& piece);

}  // namespace kdm
