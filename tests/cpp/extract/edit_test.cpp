// SPDX-License-Identifier: MIT
// New vertices in half-edge structures.
#include "extract/dual/edit.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/dual_mesh_check.h"
#include "support/dual_mesh_shapes.h"
#include "support/mesh_assert.h"

namespace kdm {
namespace {

DualMesh tetrahedron() {
  DualMesh mesh = shapes::dual_mesh({{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}});
  find_loops({}, mesh);
  mesh.position = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)};
  return mesh;
}

TEST(Edit, AnEdgeTakesAVertexAndTwoTriangles) {
  for (Index ab = 0; ab < 12; ++ab) {
    DualMesh mesh = tetrahedron();
    const Index a = mesh.vertex[ab];
    const Index b = mesh.vertex[mesh.opposite[ab]];
    const Index m = divide_edge(ab, Vec3(2, 3, 4), mesh);
    check::expect_sound(mesh);
    EXPECT_EQ(mesh.triangles(), 6u);
    EXPECT_EQ(mesh.position[m], Vec3(2, 3, 4));
    EXPECT_EQ(mesh.vertex[ab], a);
    EXPECT_EQ(mesh.vertex[next_in_triangle(ab)], m);
    EXPECT_NE(mesh.vertex[mesh.opposite[ab]], b);
    EXPECT_TRUE(check::is_two_manifold(shapes::index_mesh(mesh)));
  }
}

TEST(Edit, ATriangleBecomesThree) {
  for (Index t = 0; t < 4; ++t) {
    DualMesh mesh = tetrahedron();
    const Index m = divide_triangle(t, Vec3(2, 3, 4), mesh);
    check::expect_sound(mesh);
    EXPECT_EQ(mesh.triangles(), 6u);
    EXPECT_EQ(std::count(mesh.hit.begin(), mesh.hit.end(), t), 3);
    EXPECT_EQ(std::count(mesh.vertex.begin(), mesh.vertex.end(), m), 3);
    EXPECT_TRUE(check::is_two_manifold(shapes::index_mesh(mesh)));
  }
}

TEST(Edit, ManyDivisionsAreNamedAsBeforeTheFirst) {
  DualMesh mesh = tetrahedron();
  const std::vector<Index> corners = mesh.vertex;
  Division division(mesh);
  for (Index t = 0; t < 4; ++t) division.triangle(t, Vec3(t, 0, 0));
  std::vector<Index> middles(12, kNone);
  for (Index h = 0; h < 12; ++h) {
    const Index other = mesh.vertices();
    if (middles[h] != kNone) continue;
    const Index back = tetrahedron().opposite[h];
    division.edge(h, Vec3(0, h, back));
    middles[h] = middles[back] = other;
  }
  check::expect_sound(mesh);
  EXPECT_EQ(mesh.triangles(), 24u) << "six a triangle";
  // Each has a corner, a middle of a side and the middle of the triangle it was part of.
  for (Index t = 0; t < 24; ++t) {
    std::array<Index, 3> v = {mesh.vertex[3 * t], mesh.vertex[3 * t + 1], mesh.vertex[3 * t + 2]};
    std::sort(v.begin(), v.end());
    EXPECT_LT(v[0], 4u);
    EXPECT_EQ(v[1], 4 + mesh.hit[t]);
    bool side = false;
    for (Index h = 3 * mesh.hit[t]; h < 3 * mesh.hit[t] + 3; ++h) {
      const bool ends_there = corners[h] == v[0] || corners[next_in_triangle(h)] == v[0];
      side = side || (middles[h] == v[2] && ends_there);
    }
    EXPECT_TRUE(side);
  }
}

}  // namespace
}  // namespace kdm
