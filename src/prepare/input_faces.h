// SPDX-License-Identifier: MIT
// The faces of the input as triangles over welded points, closed and turned as far as its rule
// asks.
#pragma once

#include <vector>

#include "kdmanifold/build.h"
#include "kdmanifold/mesh.h"
#include "mesh/topology.h"

namespace kdm {

struct InputFaces {
  std::vector<Vec3> points;
  std::vector<Triangle> triangles;  ///< none has equal corners
  std::vector<Index> source;        ///< what the input calls the face each came from
  Topology topology;
  Box bounds;          ///< of the triangles
  InputReport report;  ///< all that does not need the lattice
  bool repair = false;
};

/// How far the result may be from the input, model units, where its bounding box has this diagonal.
inline double tolerance_of(const BuildOptions& options, double diagonal) {
  return options.tolerance > 0 ? options.tolerance : options.relative_tolerance * diagonal;
}

/// Checks and converts, by `inside`, the tolerance and the largest hole of the options. Throws
/// `kInvalidMesh` (no triangles, index out of range, coordinate not finite or beyond 1e150) and
/// `kNotClosed`. What is to be repaired is sewn together where rims are no further apart than the
/// tolerance, and turned outwards; if that closes it, it is a solid like any other. A sheet may be
/// open and is neither turned nor freed of faces that lie back to back.
InputFaces prepare_faces(const Mesh& mesh, const BuildOptions& options);

}  // namespace kdm
