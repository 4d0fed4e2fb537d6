// SPDX-License-Identifier: MIT
// How a sheet goes on where more than two of its triangles share an edge.
#pragma once

#include <span>
#include <vector>

#include "mesh/topology.h"

namespace kdm {

/// Pairs the sides on edges of three or more triangles anew: those first that go on straightest.
/// So sheets that cross along an edge pass through each other, and the two sides of a wall without
/// thickness stay two. Edges of more than 64 sides are left as they are. Sides paired run against
/// each other, as before, and are as many.
void pair_straightest(std::span<const Triangle> triangles, const std::vector<Vec3>& points,
                      Topology& topology);

}  // namespace kdm
