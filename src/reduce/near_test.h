// SPDX-License-Identifier: MIT
// Whether a step keeps the mesh near to the reference, and the reference near to the mesh.
#pragma once

#include "reduce/workpiece.h"

namespace kdm {

/// Tells whether the ring would be within the distance kept: the new vertex and points along its
/// edges are near to the reference, and the samples of the ring's triangles find a place there.
/// Afterwards `samples.move(ring)` is possible.
bool stays_near(Workpiece& piece, const CollapseRing& ring);

/// Tells whether points along a new edge between two vertices are near to the reference.
bool edge_stays_near(const Workpiece& piece, VertexId from, VertexId to);

}  // namespace kdm
