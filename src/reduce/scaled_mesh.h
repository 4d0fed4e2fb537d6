// SPDX-License-Identifier: MIT
// A mesh as the reducer reads it: triangles only, coordinates of about 1.
#pragma once

#include <array>
#include <vector>

#include "kdmanifold/mesh.h"

namespace kdm {

/// Triangles over scaled positions, with what results take over from them.
struct ScaledMesh {
  std::vector<Vec3> positions;  ///< the mesh's times a power of two
  std::vector<Triangle> triangles;
  std::vector<Index> source_faces;                   ///< one a triangle, or empty
  std::vector<Index> source_operands;                ///< one a triangle, or empty
  std::vector<std::array<float, 3>> corner_normals;  ///< three a triangle, or empty

  std::array<Vec3, 3> corners(Index t) const {
    return {positions[triangles[t][0]], positions[triangles[t][1]], positions[triangles[t][2]]};
  }
  std::vector<std::array<Vec3, 3>> all_corners() const;
};

/// Scales the mesh by 2^exponent and cuts its quads along their first diagonal.
ScaledMesh scaled_mesh(const Mesh& mesh, int exponent);

}  // namespace kdm
