// SPDX-License-Identifier: MIT
// The input as construction sees it: welded, on the lattice; a solid's closed, facing outwards.
#pragma once

#include <vector>

#include "geometry/lattice.h"
#include "geometry/plane.h"
#include "kdmanifold/build.h"
#include "kdmanifold/mesh.h"
#include "mesh/topology.h"

namespace kdm {

/// Triangles by number; all arrays run parallel. Triangles with a repeated corner are gone.
struct Surface {
  Lattice lattice;
  double diagonal = 0;  ///< of the bounding box, model units
  std::vector<LatticeTriangle> triangles;
  std::vector<Triangle> corners;    ///< numbers of the corners' points
  std::vector<Plane> planes;        ///< of the triangles before rounding; then of invented hits
  std::vector<Index> source_faces;  ///< what the input calls the face
  std::vector<char> degenerate;     ///< no area on the lattice: never hit, but still a neighbour
  Topology topology;
  InputReport report;
  bool sheet = false;   ///< bounds no solid
  bool repair = false;  ///< not closed or not turned consistently, but to become a solid

  bool has_rims() const { return sheet || repair; }  ///< sides may lack a twin
};

/// How far the result may be from the input, model units, where its bounding box has this diagonal.
inline double tolerance_of(const BuildOptions& options, double diagonal) {
  return options.tolerance > 0 ? options.tolerance : options.relative_tolerance * diagonal;
}

/// Checks and converts, by `inside` and the tolerance of the options. Throws `kInvalidMesh` (no
/// triangles, index out of range, coordinate not finite or beyond 1e150, all points equal) and
/// `kNotClosed`. What is to be repaired is sewn together where rims are no further apart than the
/// tolerance, and turned outwards; if that closes it, it is a solid like any other. A sheet may be
/// open and is neither turned nor freed of faces that lie back to back.
Surface prepare_surface(const Mesh& mesh, const BuildOptions& options = {});

}  // namespace kdm
