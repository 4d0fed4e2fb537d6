// SPDX-License-Identifier: MIT
// How far the surface may move where walls are thin.
#pragma once

#include <vector>

#include "reduce/reference.h"
#include "reduce/scaled_mesh.h"

namespace kdm {

/// Returns for each vertex how far the surface round it may be from the reference: `error`, but
/// where the solid behind the vertex is thinner than eight times that, an eighth of its thickness,
/// so that a wall, which has two sides, keeps its thickness within a quarter. Where the mesh itself
/// is further than that from the reference, it may stay as far, up to an eighth of the error.
/// `surface` holds the mesh's triangles; `near` one of the reference's near to each vertex, or
/// kNone.
std::vector<double> local_limits(const ScaledMesh& mesh, const Reference& surface,
                                 const Reference& reference, const std::vector<TriangleId>& near,
                                 double error);

}  // namespace kdm
