// SPDX-License-Identifier: MIT
// The input as construction sees it: welded, on the lattice; a solid's closed, facing outwards.
#pragma once

#include <vector>

#include "geometry/lattice.h"
#include "geometry/plane.h"
#include "kdmanifold/build.h"
#include "kdmanifold/mesh.h"
#include "mesh/marks.h"
#include "mesh/topology.h"
#include "prepare/input_faces.h"

namespace kdm {

/// Triangles by number; all arrays run parallel. Triangles with a repeated corner are gone.
struct Surface {
  Lattice lattice;
  double diagonal = 0;  ///< of the bounding box, model units
  std::vector<LatticeTriangle> triangles;
  std::vector<Triangle> corners;    ///< numbers of the corners' points
  std::vector<Plane> planes;        ///< of the triangles before rounding, lattice units
  std::vector<Index> source_faces;  ///< what the input calls the face
  Marks degenerate;  ///< triangles without area on the lattice: never hit, but still neighbours
  Topology topology;
  InputReport report;
  bool sheet = false;   ///< bounds no solid
  bool repair = false;  ///< not closed or not turned consistently, but to become a solid

  bool has_rims() const { return sheet || repair; }  ///< sides may lack an opposite
};

/// Checks and converts (prepare/input_faces.h). Throws `kInvalidMesh` and `kNotClosed`.
Surface prepare_surface(const Mesh& mesh, const BuildOptions& options = {});

}  // namespace kdm
