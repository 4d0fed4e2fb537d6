// SPDX-License-Identifier: MIT
// Holds the input's faces while they are prepared.
#pragma once

#include <vector>

#include "kdmanifold/grid.h"
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

}  // namespace kdm
