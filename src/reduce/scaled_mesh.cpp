// SPDX-License-Identifier: MIT
// Copies the triangles, then the quads as two triangles each.
#include "reduce/scaled_mesh.h"

#include "mesh/scale.h"

namespace kdm {

std::vector<std::array<Vec3, 3>> ScaledMesh::all_corners() const {
  std::vector<std::array<Vec3, 3>> all;
  all.reserve(triangles.size());
  for (Index t = 0; t < triangles.size(); ++t) all.push_back(corners(t));
  return all;
}

ScaledMesh scaled_mesh(const Mesh& mesh, int exponent) {
  ScaledMesh out{scaled(mesh.positions, exponent), mesh.triangles, mesh.source_faces,
                 mesh.source_operands, mesh.corner_normals};
  if (mesh.quads.empty()) return out;
  const std::size_t triangles = mesh.triangles.size();
  if (!out.source_faces.empty()) out.source_faces.resize(triangles);
  if (!out.source_operands.empty()) out.source_operands.resize(triangles);
  if (!out.corner_normals.empty()) out.corner_normals.resize(3 * triangles);
  for (std::size_t i = 0; i < mesh.quads.size(); ++i) {
    for (const std::array<std::size_t, 3>& half :
         {std::array<std::size_t, 3>{0, 1, 2}, {0, 2, 3}}) {
      const Quad& q = mesh.quads[i];
      out.triangles.push_back({q[half[0]], q[half[1]], q[half[2]]});
      if (!mesh.source_faces.empty()) {
        out.source_faces.push_back(mesh.source_faces[triangles + i]);
      }
      if (!mesh.source_operands.empty()) {
        out.source_operands.push_back(mesh.source_operands[triangles + i]);
      }
      if (mesh.corner_normals.empty()) continue;
      for (const std::size_t corner : half) {
        out.corner_normals.push_back(mesh.corner_normals[3 * triangles + 4 * i + corner]);
      }
    }
  }
  return out;
}

}  // namespace kdm
