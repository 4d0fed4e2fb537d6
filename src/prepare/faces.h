// SPDX-License-Identifier: MIT
// Holds the input's faces while they are prepared.
#pragma once

#include <vector>

#include "kdmanifold/grid.h"
#include "mesh/topology.h"

namespace kdm {

/// The plane that stands for a triangle of a patch.
struct PatchPlane {
  Vec3 normal = Vec3::Zero();  ///< zero: the plane through the triangle's corners does
  Vec3 point = Vec3::Zero();   ///< in model units
};

/// Triangles over points that are all different, in model units.
struct InputFaces {
  std::vector<Vec3> points;
  std::vector<Triangle> triangles;  ///< numbers of points; none has equal corners
  /// Per triangle: the face of the input that it came from. Of patches that close holes: kPatch, or
  /// kNone if they are too narrow for their planes to mean anything.
  std::vector<Index> source_faces;
  std::vector<PatchPlane> patch_planes;  ///< of the patches' triangles, which are the last ones
  Topology topology;                     ///< which sides of the triangles are joined
  Box bounds;                            ///< of the triangles
  InputReport report;                    ///< complete, except for what depends on the lattice
  bool repair = false;  ///< the faces are to bound a solid, but do not form closed surfaces
};

}  // namespace kdm
