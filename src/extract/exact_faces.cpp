// SPDX-License-Identifier: MIT
#include "extract/exact_faces.h"

#include <vector>

#include "extract/place/normals.h"
#include "geometry/triangle.h"
#include "geometry/triangle_triangle.h"
#include "mesh/box_tree.h"
#include "mesh/boxes.h"
#include "mesh/scale.h"
#include "mesh/topology.h"

namespace kdm {
namespace {

std::vector<std::array<float, 3>> normals_of(const Mesh& exact, double crease_cosine) {
  DualMesh mesh;
  const auto points = static_cast<Index>(exact.positions.size());
  mesh.opposite = build_topology(exact.triangles, points).opposite;
  mesh.position = exact.positions;
  mesh.first_half_edge.assign(points, kNone);
  std::vector<Vec3> face_normals;
  for (const Triangle& t : exact.triangles) {
    for (const Index v : t) {
      mesh.first_half_edge[v] = static_cast<HalfEdgeId>(mesh.vertex.size());
      mesh.vertex.push_back(v);
    }
    const auto& p = exact.positions;
    face_normals.push_back(unit_normal(p[t[0]], p[t[1]], p[t[2]]));
  }
  std::vector<std::array<float, 3>> normals;
  for (const Vec3& normal : corner_normals(mesh, face_normals, crease_cosine)) {
    const Eigen::Vector3f n = normal.cast<float>();
    normals.push_back({n[0], n[1], n[2]});
  }
  return normals;
}

// Inserts what belongs to the new triangles behind what belongs to the old ones: `each` entries a
// triangle.
template <typename T>
void insert_behind(std::size_t triangles, std::size_t each, const std::vector<T>& added,
                   std::vector<T>& to) {
  if (added.empty()) return;
  to.insert(to.begin() + static_cast<std::ptrdiff_t>(each * triangles), added.begin(), added.end());
}

}  // namespace

void append_exact(const Mesh& exact, const ExtractOptions& options, Mesh& out) {
  const std::size_t triangles = out.triangles.size();
  const auto first = static_cast<Index>(out.positions.size());
  out.positions.insert(out.positions.end(), exact.positions.begin(), exact.positions.end());
  for (const Triangle& t : exact.triangles) {
    out.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  }
  insert_behind(triangles, 1, exact.source_faces, out.source_faces);
  insert_behind(triangles, 1, exact.source_operands, out.source_operands);
  if (!options.normals) return;
  const double crease = cosine_of_degrees(options.crease_angle);
  insert_behind(triangles, 3, normals_of(exact, crease), out.corner_normals);
}

std::uint64_t count_crossings(const Mesh& mesh, const Mesh& other) {
  std::vector<Vec3> both = mesh.positions;
  both.insert(both.end(), other.positions.begin(), other.positions.end());
  const std::vector<Vec3> positions = scale_to_one(both).positions;
  const auto first = static_cast<Index>(mesh.positions.size());
  const auto corners = [&](const Triangle& t) {
    return std::array<Vec3, 3>{positions[t[0]], positions[t[1]], positions[t[2]]};
  };
  std::vector<Triangle> others;
  std::vector<Box> boxes;
  for (const Triangle& t : other.triangles) {
    others.push_back({t[0] + first, t[1] + first, t[2] + first});
    const auto [a, b, c] = corners(others.back());
    boxes.push_back(box_of(a, b, c));
  }
  const BoxTree tree(boxes);
  std::uint64_t pairs = 0;
  for (const Triangle& t : mesh.triangles) {
    const auto own = corners(t);
    tree.for_each_meeting(box_of(own[0], own[1], own[2]), [&](Index i) {
      pairs += TriangleCrossing<RealKernel>::test(own, t, corners(others[i]), others[i]) ? 1 : 0;
    });
  }
  return pairs;
}

}  // namespace kdm
