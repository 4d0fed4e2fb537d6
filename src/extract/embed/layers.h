// SPDX-License-Identifier: MIT
// Several loops in a leaf, each with a surface that keeps clear of the others'.
#pragma once

#include <span>

#include "extract/dual/edit_log.h"

namespace kdm {

/// Replaces the triangles round the vertices of these loops, which are all of one leaf and at level
/// `kLinksApart` or above: each has its ring on the sides of the leaf's box. Through the middle of
/// the leaf no fans of theirs may lead past each other; so the ring is drawn inwards, more the more
/// loops lie within it, and closed there by the side of the box within it, drawn inwards as much:
///
///        +---o===o---+         o rings, = caps
///        |   |_._|   |
///        | o-------o |         Caps of different depth do not meet, nor do those side by side,
///        | |_______| |         whatever the rings look like.
///        +-o-------o-+
///
/// False if it cannot be done: a loop is on the boundary, not at that level, or rings meet.
bool draw_inwards(const LatticeBox& box, std::span<const Index> loops, DualMesh& mesh,
                  EditLog& log);

}  // namespace kdm
