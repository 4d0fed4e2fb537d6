// SPDX-License-Identifier: MIT
// Closed rounds of boundary edges.
#pragma once

#include <span>
#include <vector>

#include "mesh/faults.h"

namespace kdm {

struct BoundaryLoop {
  std::vector<Index> vertices;
  Index face = kNone;  ///< one along it
};

/// Follows boundary edges round the fans at their ends, in which exactly two meet if no edge there
/// has three or more faces. Where others do, rounds are closed as early as can be, and edges that
/// are part of none are left out. Loops start with their lowest edge in the list where they can.
std::vector<BoundaryLoop> find_boundary_loops(std::span<const BoundaryEdge> edges);

/// Such rounds along the sides without twin of a triangle mesh (see `Topology`), also of those at
/// edges with several faces: from each to the next one round the corner. Sides stand for the
/// vertices that they start from.
std::vector<BoundaryLoop> find_rim_loops(std::span<const Index> twin);

}  // namespace kdm
