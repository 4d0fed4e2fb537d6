// SPDX-License-Identifier: MIT
// Whether a step keeps the mesh near to the reference, and the reference near to the mesh.
#pragma once

#include "reduce/workpiece.h"

namespace kdm {

/// What a test finds out, for the step that may follow.
struct NearFind {
  Samples::Places places;  ///< where the samples would go
  TriangleId near =
      kNone;  ///< the reference's triangle that was found near the vertex that is kept
};

/// Tells whether the ring would be within the distance kept: the new vertex and points along its
/// edges are near to the reference, and the samples of the ring's triangles find a place there.
bool stays_near(const Workpiece& piece, const CollapseRing& ring, NearFind& found);

/// Tells whether points along a new edge between two vertices are near to the reference.
bool edge_stays_near(const Workpiece& piece, VertexId from, VertexId to);

}  // namespace kdm
