// SPDX-License-Identifier: MIT
// Joins boundary edges to closed rounds.
#pragma once

#include <span>
#include <vector>

#include "mesh/faults.h"
#include "mesh/sides.h"

namespace kdm {

/// A closed round of boundary edges.
struct BoundaryLoop {
  std::vector<Index> vertices;  ///< in the direction of the faces, where these agree
  Index face = kNone;           ///< the number of a face with an edge of the round
};

/// Joins boundary edges to loops: each edge is followed by one that starts in the same fan at its
/// end. (A fan is a set of faces at one vertex that are joined by edges; see `BoundaryEdge`.)
/// Exactly two boundary edges meet in a fan if no edge there has three or more faces. Where more
/// meet, loops are closed as early as possible, and edges that are part of no loop are left out. A
/// loop starts with its lowest edge in the list unless it was cut off from a longer one.
std::vector<BoundaryLoop> find_boundary_loops(std::span<const BoundaryEdge> edges);

/// Joins the sides of a triangle mesh that have no opposite (see `Topology::opposite`) to loops:
/// from each side to the next one round the corner at its end. Sides at edges of several triangles
/// take part like any other. In the loops' `vertices`, a side stands for the corner that it starts
/// from, since one position may be passed several times.
std::vector<BoundaryLoop> find_rim_loops(std::span<const SideId> opposite);

}  // namespace kdm
