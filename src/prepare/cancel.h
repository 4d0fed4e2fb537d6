// SPDX-License-Identifier: MIT
// Faces that lie back to back and bound nothing.
#pragma once

#include <span>
#include <vector>

#include "mesh/topology.h"

namespace kdm {

/// Finds pairs of triangles over the same three corners that face opposite ways. Each triangle is
/// in one pair at most. Returns one flag a triangle. `topology` is theirs, `points` bounds the
/// corner numbers. Linear time for meshes of bounded valence.
std::vector<char> find_opposite_pairs(std::span<const Triangle> triangles, Index points,
                                      const Topology& topology);

}  // namespace kdm
