// SPDX-License-Identifier: MIT
// Triangles that may lie over the same points as others.
#pragma once

#include <vector>

#include "mesh/numbers.h"
#include "mesh/topology.h"

namespace kdm {

/// Finds the triangles that may have the same three points as another one; all that have are among
/// them. Such two share three edges: each side of theirs is on an edge of three or more triangles,
/// or has the other triangle beyond it, or none because both run the same way. `topology` must be
/// that of the triangles. Takes linear time.
std::vector<TriangleId> find_possible_twins(const Topology& topology);

}  // namespace kdm
