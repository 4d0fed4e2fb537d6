// SPDX-License-Identifier: MIT
// Gives several loops in one leaf surfaces that do not meet each other.
#pragma once

#include <span>

#include "extract/dual/edit_log.h"

namespace kdm {

// clang-format off

/// Replaces the triangles round the vertices of these loops, which all lie in the leaf of this box.
/// At level `kLinksApart` or above, the ring round such a vertex lies on the sides of the box, and
/// the rings of several loops do not meet. But triangles from the rings to vertices in the middle
/// of the leaf may cross. So each ring is copied on a smaller box round the same middle and joined
/// to its copy; the copy is closed by its cap, the part of the smaller box's surface on one side of
/// the ring. The more rings lie within a cap, the smaller is its box:
///
///        +---o===o---+         box of the leaf
///        |   |___|   |         o   vertices of two rings, one within the other
///        | o-------o |         === copies of the rings and their caps on smaller boxes
///        | |_______| |
///        +-o-------o-+
///
/// Caps on boxes of different sizes do not meet, nor do those beside each other on one box, whatever
/// the rings look like.
///
/// Returns false, and changes nothing, if it cannot be done: the box is too small, a loop is on the
/// boundary or below that level, or rings meet.
bool nest_loops(const LatticeBox& box, std::span<const LoopId> loops, DualMesh& mesh,
                EditLog& log);

// clang-format on

}  // namespace kdm
