// SPDX-License-Identifier: MIT
// Faces of a mesh that cross or touch where they share nothing.
#include <new>

#include "geometry/triangle_triangle.h"
#include "kdmanifold/error.h"
#include "kdmanifold/mesh.h"
#include "mesh/box_tree.h"
#include "mesh/check_indices.h"
#include "mesh/polygons.h"
#include "mesh/scale.h"

namespace kdm {
namespace {

struct Corners {
  Triangle numbers;
  Index face;
};

std::vector<Corners> triangles_of(const Mesh& mesh) {
  std::vector<Corners> triangles;
  triangles.reserve(mesh.triangles.size() + 2 * mesh.quads.size());
  Polygons(mesh).for_each_triangle([&](Index face, const Triangle& t) {
    triangles.push_back({t, face});
  });
  return triangles;
}

}  // namespace

SelfIntersections find_self_intersections(const Mesh& mesh) try {
  check_indices(mesh);
  const std::vector<Corners> triangles = triangles_of(mesh);
  const std::vector<Vec3> positions = scale_to_one(mesh.positions).positions;
  const auto corners = [&](Index t) {
    const Triangle& n = triangles[t].numbers;
    return std::array<Vec3, 3>{positions[n[0]], positions[n[1]], positions[n[2]]};
  };
  std::vector<Box> boxes;
  boxes.reserve(triangles.size());
  for (Index t = 0; t < triangles.size(); ++t) {
    const auto [a, b, c] = corners(t);
    boxes.push_back({a.cwiseMin(b).cwiseMin(c), a.cwiseMax(b).cwiseMax(c)});
  }
  SelfIntersections result;
  std::vector<char> crossing(mesh.triangles.size() + mesh.quads.size(), 0);
  BoxTree(boxes).for_each_pair([&](Index i, Index j) {
    if (triangles[i].face == triangles[j].face) return;
    if (!TriangleCrossing<RealKernel>::test(corners(i), triangles[i].numbers, corners(j),
                                            triangles[j].numbers)) {
      return;
    }
    ++result.pairs;
    crossing[triangles[i].face] = crossing[triangles[j].face] = 1;
  });
  for (Index face = 0; face < crossing.size(); ++face) {
    if (crossing[face] != 0) result.faces.push_back(face);
  }
  return result;
} catch (const std::bad_alloc&) {
  throw Error(ErrorCode::kOutOfMemory, "there is not enough memory to look for crossings");
}

}  // namespace kdm
