// SPDX-License-Identifier: MIT
#include "csg/open_parts.h"

#include <algorithm>
#include <utility>

#include "kdmanifold/error.h"
#include "mesh/sides.h"
#include "prepare/input_faces.h"

namespace kdm {
namespace {

void append(const Mesh& more, Mesh& mesh) {
  const auto first = static_cast<Index>(mesh.positions.size());
  mesh.positions.insert(mesh.positions.end(), more.positions.begin(), more.positions.end());
  for (const auto& [a, b, c] : more.triangles) {
    mesh.triangles.push_back({a + first, b + first, c + first});
  }
  mesh.source_faces.insert(mesh.source_faces.end(), more.source_faces.begin(),
                           more.source_faces.end());
}

}  // namespace

FaceParts parts_of(const InputFaces& faces) {
  FaceParts parts;
  parts.of = find_parts(faces.topology);
  parts.of.resize(faces.triangles.size(), 0);  // it is empty if there is but one part
  const Index count = 1 + *std::max_element(parts.of.begin(), parts.of.end());
  parts.open.assign(count);
  for (SideId side = 0; side < faces.topology.opposite.size(); ++side) {
    if (faces.topology.opposite[side] == kNone) parts.open.set(parts.of[triangle_of(side)]);
  }
  return parts;
}

PartsMesh mesh_of_parts(const InputFaces& faces, const FaceParts& parts, bool open) {
  PartsMesh taken;
  taken.mesh.positions = faces.points;
  for (TriangleId t = 0; t < faces.triangles.size(); ++t) {
    if (parts.open_triangle(t) != open) continue;
    taken.mesh.triangles.push_back(faces.triangles[t]);
    taken.mesh.source_faces.push_back(faces.source_faces[t]);
    taken.part_of.push_back(parts.of[t]);
  }
  return taken;
}

void insert_closed(const Mesh& solid, InputFaces& faces) {
  const auto first = static_cast<Index>(faces.points.size());
  const auto at = static_cast<std::ptrdiff_t>(faces.triangles.size() - faces.patch_planes.size());
  faces.points.insert(faces.points.end(), solid.positions.begin(), solid.positions.end());
  std::vector<Triangle> triangles = solid.triangles;
  for (Triangle& t : triangles) {
    for (Index& corner : t) corner += first;
  }
  std::vector<Index> source_faces = solid.source_faces;
  std::replace(source_faces.begin(), source_faces.end(), kNone, kPatch);
  faces.triangles.insert(faces.triangles.begin() + at, triangles.begin(), triangles.end());
  faces.source_faces.insert(faces.source_faces.begin() + at, source_faces.begin(),
                            source_faces.end());
}

void add_repairs(const InputReport& more, InputReport& sum) {
  sum.sewn_edges += more.sewn_edges;
  sum.sewing_distance = std::max(sum.sewing_distance, more.sewing_distance);
  sum.patched_holes += more.patched_holes;
  sum.patch_area += more.patch_area;
}

OpenParts prepare_by_themselves(Mesh open, const BuildOptions& options) {
  OpenParts result;
  while (!open.triangles.empty()) {
    try {
      result.faces = prepare_faces(open, options);
    } catch (const Error& error) {
      if (error.code() != ErrorCode::kNotClosed || result.closed.triangles.empty()) throw;
      result.faces = {};
      break;
    }
    add_repairs(result.faces.report, result.done);
    const FaceParts parts = parts_of(result.faces);
    if (result.faces.repair && !parts.some_closed()) break;
    append(mesh_of_parts(result.faces, parts, false).mesh, result.closed);
    open = mesh_of_parts(result.faces, parts, true).mesh;
    result.faces = {};
  }
  return result;
}

}  // namespace kdm
