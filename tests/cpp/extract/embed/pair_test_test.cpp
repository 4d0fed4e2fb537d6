// SPDX-License-Identifier: MIT
// Whether triangles have an area is decided exactly.
#include <gtest/gtest.h>

#include "extract/embed/pair_test.h"
#include "support/dual_mesh_shapes.h"

namespace kdm {
namespace {

// Returns whether a triangle with these corners, in model units, counts as one without area.
bool has_no_area(const Vec3& a, const Vec3& b, const Vec3& c) {
  GridData grid;
  const std::vector<LatticeBox> boxes;
  const std::vector<Vec3> points;
  DualMesh mesh = shapes::dual_mesh({{0, 1, 2}, {0, 2, 1}});
  mesh.position = {a, b, c};
  PairTest test({grid, boxes, points});
  test.update(mesh);
  test.read_corners(mesh, 0);
  return test.has_no_area(mesh, 0);
}

TEST(PairTest, FindsTrianglesWithoutArea) {
  EXPECT_TRUE(has_no_area({0, 0, 0}, {1, 2, 3}, {2, 4, 6}));
  EXPECT_TRUE(has_no_area({1, 2, 3}, {1, 2, 3}, {2, 4, 5}));
  EXPECT_FALSE(has_no_area({0, 0, 0}, {1, 2, 3}, {2, 4, 7}));
}

// The coordinates' differences, rounded to 53 bits, give a cross product of zero.
TEST(PairTest, SeesTheLeastArea) {
  const Vec3 a(3.381194e-11f, 3.381196e-11f, 0);
  const Vec3 b(1, 1, 0);
  const Vec3 c(0.5, 0.5, 0);
  EXPECT_TRUE((b - a).cross(c - a).isZero(0));
  EXPECT_FALSE(has_no_area(a, b, c));
}

}  // namespace
}  // namespace kdm
