// SPDX-License-Identifier: MIT
// The input as all later steps see it: triangles over welded points, rounded to the lattice. It is
// not changed any more.
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

/// The input's triangles. They are numbered, and most arrays have one entry for each; triangles
/// with two equal corners are left out. Unless `has_rims()`, the triangles form closed surfaces
/// that enclose a volume that is not negative.
struct Surface {
  Lattice lattice;
  double extent = 0;  ///< what a relative tolerance is a fraction of (see InputReport), model units
  std::vector<LatticeTriangle> triangles;
  std::vector<Triangle> corners;    ///< the welded points (PointId) that the corners lie at
  std::vector<Vec3> points;         ///< the welded points, in model units
  std::vector<Plane> planes;        ///< of the triangles before rounding, in lattice units
  std::vector<Index> source_faces;  ///< as in InputFaces: the face that each triangle came from
  Marks degenerate;   ///< triangles without area on the lattice: no grid line crosses them
  Topology topology;  ///< which sides of the triangles are joined
  /// Per triangle the number of its part (see `find_parts`); empty if there is one.
  std::vector<Index> part_of;
  InputReport report;
  /// Of a Boolean operation: per triangle the number of its solid, and per solid the number of the
  /// operand that the user gave (kNone: it was invented). Otherwise empty.
  std::vector<Index> solid_of;
  std::vector<Index> operand_of_solid;
  bool sheet = false;    ///< it bounds no solid
  bool patched = false;  ///< some of its triangles close holes, and may cross the others
  bool repair = false;   ///< it is to bound a solid, but it is not closed or its triangles do not
                         ///< face consistently

  bool has_operands() const { return !operand_of_solid.empty(); }
  bool several_solids() const { return operand_of_solid.size() > 1; }
  /// Returns whether sides of triangles may lack an opposite.
  bool has_rims() const { return sheet || repair; }
};

/// Returns the lattice that the options ask for over the bounding box of faces, in model units.
/// Throws `kInvalidOption` if the options have a box that does not hold it.
Lattice lattice_for(const Box& bounds, const BuildOptions& options);

/// Rounds prepared faces to a lattice that holds them, and turns a solid that is inside out.
Surface surface_of(InputFaces faces, const Lattice& lattice, bool sheet);

/// Rounds prepared faces to the lattice over them. The inside rule of the options says whether they
/// are a sheet.
Surface prepare_surface(InputFaces faces, const BuildOptions& options);

/// Checks the mesh, prepares its faces for the inside rule of the options (see
/// prepare/input_faces.h), rounds them to the lattice and turns a solid that is inside out. Throws
/// `kInvalidMesh` and `kNotClosed`. Takes time linear in the number of faces, apart from sorting.
inline Surface prepare_surface(const Mesh& mesh, const BuildOptions& options = {}) {
  return prepare_surface(prepare_faces(mesh, options), options);
}

}  // namespace kdm
