// SPDX-License-Identifier: MIT
// Opens contacts: where parts of the result touch, their vertices move apart a little.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "extract/dual/dual_mesh.h"

namespace kdm {

/// Moves the vertices at which triangles of the pairs touch: the corners of one triangle that lie
/// within `reach` of the other and, if there are none, the ends of a side that does. Corners that
/// both have stay where they are. On a convex edge or corner of the surface a vertex moves inwards,
/// on a concave one outwards, and where the surface bends both ways towards its neighbours; where
/// it is flat it stays. It moves by `step`, and by an eighth of its shortest edge at most. `reach`
/// and `step` are lattice units. Returns the vertices that were moved; ascending.
std::vector<VertexId> part_contacts(std::span<const std::pair<TriangleId, TriangleId>> pairs,
                                    double reach, double step, DualMesh& mesh);

}  // namespace kdm
