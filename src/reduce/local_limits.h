// SPDX-License-Identifier: MIT
// How far the surface may move where walls are thin, and where it is near to itself.
#pragma once

#include <vector>

#include "mesh/marks.h"
#include "reduce/reference.h"
#include "reduce/scaled_mesh.h"

namespace kdm {

/// What holds round each vertex.
struct LocalLimits {
  /// How far the surface may be from the reference: `error`, but where the solid behind the vertex
  /// is thinner than eight times that, an eighth of its thickness, so that a wall, which has two
  /// sides, keeps its thickness within a quarter. Where the mesh itself is further than that from
  /// the reference, it may stay as far, up to an eighth of the error.
  std::vector<double> distance;
  /// Marks vertices straight before or behind which there is another wall of the mesh, nearer than
  /// four times the error.
  Marks narrow;
};

/// Looks along the normal of each vertex, both ways, and behind the sides of sharp edges. `surface`
/// holds the mesh's triangles; `near` one of the reference's near to each vertex, or kNone.
LocalLimits local_limits(const ScaledMesh& mesh, const Reference& surface,
                         const Reference& reference, const std::vector<TriangleId>& near,
                         double error);

}  // namespace kdm
