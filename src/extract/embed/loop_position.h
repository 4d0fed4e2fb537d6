// SPDX-License-Identifier: MIT
// Finds positions for the vertices of loops such that the triangles round them stay in their
// leaves.
#pragma once

#include "extract/dual/embed_level.h"
#include "extract/dual/grid_view.h"

namespace kdm {

/// Returns the point of the box that is nearest to `point` and keeps off the box's sides: by 1/32
/// of the box's size or by half of `tolerance` (lattice units), whichever is less.
Vec3 off_sides(const LatticeBox& box, double tolerance, const Vec3& point);

/// Returns the position of the loop's vertex at this level. Below `kOffSides` it is the present
/// position; below `kCentred` the present position, moved off the sides of the leaf; at higher
/// levels a point amid the loop's hits. `loops` must have one triangle for each hit.
Vec3 loop_position(const GridView& view, const DualMesh& loops, LoopId v, EmbedLevel level);

}  // namespace kdm
