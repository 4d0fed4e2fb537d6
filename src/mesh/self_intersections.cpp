// SPDX-License-Identifier: MIT
// Faces of a mesh that cross or touch where they share nothing.
#include <new>

#include "geometry/triangle_triangle.h"
#include "kdmanifold/error.h"
#include "kdmanifold/mesh.h"
#include "mesh/box_tree.h"
#include "mesh/check_indices.h"
#include "mesh/scaled.h"

namespace kdm {
namespace {

struct Triangles {
  std::vector<Triangle> corners;
  std::vector<Index> face;  // of the mesh: triangles first, then quads
};

Triangles triangles_of(const Mesh& mesh) {
  Triangles result;
  result.corners = mesh.triangles;
  result.corners.reserve(mesh.triangles.size() + 2 * mesh.quads.size());
  for (const Quad& q : mesh.quads) {
    result.corners.push_back({q[0], q[1], q[2]});
    result.corners.push_back({q[0], q[2], q[3]});
  }
  const auto triangles = static_cast<Index>(mesh.triangles.size());
  for (Index i = 0; i < result.corners.size(); ++i) {
    result.face.push_back(i < triangles ? i : triangles + (i - triangles) / 2);
  }
  return result;
}

}  // namespace

SelfIntersections find_self_intersections(const Mesh& mesh) try {
  check_indices(mesh);
  const Triangles triangles = triangles_of(mesh);
  const std::vector<Vec3> positions =
      scaled(mesh.positions, -exponent_of(mesh.positions, triangles.corners));
  const auto corners = [&](Index t) {
    const Triangle& n = triangles.corners[t];
    return std::array<Vec3, 3>{positions[n[0]], positions[n[1]], positions[n[2]]};
  };
  std::vector<Box> boxes;
  boxes.reserve(triangles.corners.size());
  for (Index t = 0; t < triangles.corners.size(); ++t) {
    const auto [a, b, c] = corners(t);
    boxes.push_back({a.cwiseMin(b).cwiseMin(c), a.cwiseMax(b).cwiseMax(c)});
  }
  SelfIntersections result;
  std::vector<char> crossing(mesh.triangles.size() + mesh.quads.size(), 0);
  BoxTree(boxes).for_each_pair([&](Index i, Index j) {
    if (triangles.face[i] == triangles.face[j]) return;
    if (!TriangleCrossing<RealKernel>::test(corners(i), triangles.corners[i], corners(j),
                                            triangles.corners[j])) {
      return;
    }
    ++result.pairs;
    crossing[triangles.face[i]] = crossing[triangles.face[j]] = 1;
  });
  for (Index face = 0; face < crossing.size(); ++face) {
    if (crossing[face] != 0) result.faces.push_back(face);
  }
  return result;
} catch (const std::bad_alloc&) {
  throw Error(ErrorCode::kOutOfMemory, "there is not enough memory to look for crossings");
}

}  // namespace kdm
