// SPDX-License-Identifier: MIT
// Turns the faces of the input into triangles over welded points, checks them, and repairs them as
// far as the inside rule needs.
#pragma once

#include <vector>

#include "kdmanifold/build.h"
#include "kdmanifold/mesh.h"
#include "mesh/topology.h"

namespace kdm {

/// Triangles over points that are all different, in model units.
struct InputFaces {
  std::vector<Vec3> points;
  std::vector<Triangle> triangles;  ///< numbers of points; none has equal corners
  std::vector<Index> source_faces;  ///< per triangle: the face of the input that it came from
  Topology topology;                ///< which sides of the triangles are joined
  Box bounds;                       ///< of the triangles
  InputReport report;               ///< complete, except for what depends on the lattice
  bool repair = false;  ///< the faces are to bound a solid, but do not form closed surfaces
};

/// Returns how far the result may be from the input, in model units, if the diagonal of the input's
/// bounding box has this length.
inline double tolerance_of(const BuildOptions& options, double diagonal) {
  return options.tolerance > 0 ? options.tolerance : options.relative_tolerance * diagonal;
}

/// Checks the mesh and turns it into welded triangles. Of the options, the inside rule, the
/// tolerance and the largest hole count.
///
/// Closed input loses pairs of faces that lie back to back. Open input under the rule `kRepair` is
/// sewn together where rims are no further apart than the tolerance, its parts are turned outwards,
/// and copies of faces are dropped; if that closes the surface, nothing is left to repair. A sheet
/// may be open, and its faces stay as they are.
///
/// Throws `kInvalidMesh` (no triangles, index out of range, coordinate not finite or beyond 1e150)
/// and `kNotClosed` (the input is open under a rule that accepts closed input only, or has holes
/// too wide to be closed).
InputFaces prepare_faces(const Mesh& mesh, const BuildOptions& options);

}  // namespace kdm
