// SPDX-License-Identifier: MIT
// Decides which triangles continue each other where three or more share an edge.
#pragma once

#include <span>
#include <vector>

#include "mesh/topology.h"

namespace kdm {

/// Pairs the sides on edges of three or more triangles anew: of all pairs of sides that run in
/// opposite directions, the pair across which the surface goes on straightest is made first, then
/// the straightest of what is left, and so on. So surfaces that cross along an edge pass through
/// each other, and the two faces of a wall without thickness stay separate. As many sides are
/// paired as before. Edges of more than 64 sides keep the pairs that they have. `points` are the
/// positions of the corners, in any unit.
void pair_straightest(std::span<const Triangle> triangles, const std::vector<Vec3>& points,
                      Topology& topology);

}  // namespace kdm
