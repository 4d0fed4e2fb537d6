// SPDX-License-Identifier: MIT
// Faces that lie back to back and bound nothing.
#pragma once

#include <span>
#include <vector>

#include "kdmanifold/types.h"

namespace kdm {

/// Finds pairs of triangles over the same three corners that face opposite ways. Each triangle is
/// in one pair at most. Returns one flag a triangle. Linear time for meshes of bounded valence.
std::vector<char> find_opposite_pairs(std::span<const Triangle> triangles, Index points);

}  // namespace kdm
