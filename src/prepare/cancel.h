// SPDX-License-Identifier: MIT
// Faces that lie back to back and bound nothing.
#pragma once

#include <span>

#include "mesh/marks.h"
#include "mesh/topology.h"

namespace kdm {

/// Finds pairs of triangles over the same three points that face opposite ways, and marks both
/// triangles of each pair. A triangle is in one pair at most. `topology` must be that of the
/// triangles; `points` is above all corner numbers. Takes linear time if no point has very many
/// triangles.
Marks find_opposite_pairs(std::span<const Triangle> triangles, Index points,
                          const Topology& topology);

}  // namespace kdm
