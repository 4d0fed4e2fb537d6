// SPDX-License-Identifier: MIT
// Moves vertices where that takes creases away that the reference does not have.
#pragma once

#include "reduce/smooth_test.h"
#include "reduce/workpiece.h"

namespace kdm {

/// Tells whether the reference itself turns where the triangles beside the edge are: where its
/// parts pass through each other there is no edge of it, but no false crease either.
bool turns_in_reference(const Workpiece& piece, SideId edge);

/// What came of trying to move a vertex.
enum class VertexMove {
  kMade,   ///< it was moved
  kNever,  ///< it is not moved as long as its triangles and those beside them stay what they are
  kNotNow  ///< it was not moved
};

/// Moves a vertex beside false creases (see SmoothTest) to where there are fewer, as long as its
/// triangles keep their shape, stay near to the reference and meet nothing. Needs a kept distance.
/// Vertices on lines stay.
VertexMove move_to_smooth(Workpiece& piece, SmoothTest& smooth, CrossingGuard::Scratch& crossing,
                          VertexId v);

}  // namespace kdm
