// SPDX-License-Identifier: MIT
// Vertices for more than one feature in a leaf (paper 2.3.1).
#pragma once

#include "extract/dual_mesh.h"

namespace kdm {

/// How far a vertex may lie from the plane of one of its hits: the larger of the two.
struct SplitError {
  double distance = 0;  ///< lattice units
  double of_hits = 0;   ///< fraction of the distance to the furthest of its hits
};

/// Splits each loop's vertex that lies further off: its ring is cut into sections that one vertex
/// each can serve. Returns the number of vertices added; each brings two triangles.
Index split_vertices(const GridData& grid, const std::vector<LatticeBox>& boxes,
                     const std::vector<Vec3>& points, const SplitError& error, DualMesh& mesh);

}  // namespace kdm
