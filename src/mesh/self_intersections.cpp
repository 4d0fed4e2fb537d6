// SPDX-License-Identifier: MIT
// Faces of a mesh that cross or touch where they share nothing.
#include <cmath>
#include <new>

#include "geometry/triangle_triangle.h"
#include "kdmanifold/error.h"
#include "kdmanifold/mesh.h"
#include "mesh/box_tree.h"
#include "mesh/check_indices.h"

namespace kdm {
namespace {

// Coordinates times a power of two, which rounds nothing, so that products stay in range.
std::vector<Vec3> scaled_to_one(const std::vector<Vec3>& positions) {
  double largest = 0;
  for (const Vec3& p : positions) largest = std::max(largest, p.cwiseAbs().maxCoeff());
  int exponent = 0;
  std::frexp(largest, &exponent);
  std::vector<Vec3> scaled;
  scaled.reserve(positions.size());
  for (const Vec3& p : positions) {
    scaled.emplace_back(std::ldexp(p[0], -exponent), std::ldexp(p[1], -exponent),
                        std::ldexp(p[2], -exponent));
  }
  return scaled;
}

struct Corners {
  Triangle numbers;
  Index face;  // of the mesh: triangles first, then quads
};

std::vector<Corners> triangles_of(const Mesh& mesh) {
  std::vector<Corners> triangles;
  triangles.reserve(mesh.triangles.size() + 2 * mesh.quads.size());
  Index face = 0;
  for (const Triangle& t : mesh.triangles) triangles.push_back({t, face++});
  for (const Quad& q : mesh.quads) {
    triangles.push_back({{q[0], q[1], q[2]}, face});
    triangles.push_back({{q[0], q[2], q[3]}, face++});
  }
  return triangles;
}

}  // namespace

SelfIntersections find_self_intersections(const Mesh& mesh) try {
  check_indices(mesh);
  const std::vector<Corners> triangles = triangles_of(mesh);
  const std::vector<Vec3> positions = scaled_to_one(mesh.positions);
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
