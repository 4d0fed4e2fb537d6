// SPDX-License-Identifier: MIT
// How much of a closed surface bounds nothing because it is turned outside in.
#include "prepare/outside_in.h"

#include <gtest/gtest.h>

#include "support/shapes.h"

namespace kdm {
namespace {

double share(const Mesh& mesh) {
  return share_outside_in(mesh.triangles, static_cast<Index>(mesh.triangles.size()),
                          mesh.positions);
}

TEST(OutsideIn, NothingOfAProperSurfaceIs) {
  EXPECT_EQ(share(shapes::cube()), 0);
  EXPECT_EQ(share(shapes::torus()), 0);
  EXPECT_EQ(share(shapes::nested_spheres()), 0);
  EXPECT_EQ(share(shapes::overlapping_cubes()), 0);
  EXPECT_EQ(share(shapes::nested_shells()), 0);
}

TEST(OutsideIn, AllOfAnInvertedOneIs) { EXPECT_EQ(share(shapes::inverted(shapes::torus())), 1); }

// The waist of an hour-glass is pulled through itself: a cylinder whose lower half is turned over.
TEST(OutsideIn, PartOfOneThatPassesThroughItselfIs) {
  const Mesh mesh = shapes::revolved({{0, 0}, {1, 0}, {0.001, 1}, {1, 2}, {0, 2}}, 32);
  EXPECT_EQ(share(mesh), 0);
  Mesh turned = mesh;
  for (Vec3& p : turned.positions) {
    if (p.z() < 1) p = Vec3(p.x(), p.y(), 2.5 - p.z());
  }
  EXPECT_GT(share(turned), 0.1);
  EXPECT_LT(share(turned), 0.9);
}

TEST(OutsideIn, CountsTheFirstTrianglesOnly) {
  const Mesh inverted = shapes::inverted(shapes::translated(shapes::cube(), Vec3(5, 0, 0)));
  const Mesh mesh = shapes::merged({shapes::cube(), inverted});
  EXPECT_EQ(share_outside_in(mesh.triangles, 12, mesh.positions), 0);
  EXPECT_NEAR(share(mesh), 0.5, 0.01);
}

}  // namespace
}  // namespace kdm
