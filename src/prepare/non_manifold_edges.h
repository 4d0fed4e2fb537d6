// SPDX-License-Identifier: MIT
// How a surface goes on where three or more of its triangles share an edge.
#pragma once

#include <span>
#include <vector>

#include "mesh/topology.h"

namespace kdm {

/// Pairs the sides on edges of three or more triangles anew: of all pairs of sides that run against
/// each other, those come first across which the surface goes on straightest. So surfaces that
/// cross along an edge pass through each other, and the two sides of a wall without thickness stay
/// two. As many sides are paired as before. Edges of more than 64 sides keep the pairs that they
/// have. `points` are the positions of the corners, in any unit.
void pair_straightest(std::span<const Triangle> triangles, const std::vector<Vec3>& points,
                      Topology& topology);

}  // namespace kdm
