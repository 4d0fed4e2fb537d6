// SPDX-License-Identifier: MIT
// Where loops' vertices go so that the triangles round them stay in their leaves.
#pragma once

#include "extract/dual/embed_level.h"
#include "extract/dual/grid_view.h"

namespace kdm {

/// Returns the point of the box that is nearest to this one and keeps off the box's sides: by 1/32
/// of the box's size or by half of `tolerance` (lattice units), whichever is less.
Vec3 off_sides(const LatticeBox& box, double tolerance, const Vec3& point);

/// Returns where the loop's vertex goes at this level: where it is below `kOffSides`, off the sides
/// of its leaf below `kCentred`, and else amid the loop's hits. `loops` has one triangle a hit.
Vec3 loop_position(const GridView& view, const DualMesh& loops, LoopId v, EmbedLevel level);

}  // namespace kdm
