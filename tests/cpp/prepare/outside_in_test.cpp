// SPDX-License-Identifier: MIT
// How much of a closed surface bounds nothing because it is turned outside in.
#include "prepare/outside_in.h"

#include <gtest/gtest.h>

#include "support/shapes.h"

namespace kdm {
namespace {

double share(const Mesh& mesh, Index counted) {
  const Sight sight(mesh.triangles, mesh.positions, Marks(mesh.triangles.size()));
  std::vector<TriangleId> first;
  for (TriangleId t = 0; t < counted; ++t) first.push_back(t);
  return share_outside_in(mesh.triangles, mesh.positions, sight, first, 128);
}

double share(const Mesh& mesh) { return share(mesh, static_cast<Index>(mesh.triangles.size())); }

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

TEST(OutsideIn, CountsSomeTrianglesOnly) {
  const Mesh inverted = shapes::inverted(shapes::translated(shapes::cube(), Vec3(5, 0, 0)));
  const Mesh mesh = shapes::merged({shapes::cube(), inverted});
  EXPECT_EQ(share(mesh, 12), 0);
  EXPECT_NEAR(share(mesh), 0.5, 0.01);
}

TEST(OutsideIn, TellsWhatBoundsSomething) {
  const auto bounding = [](const Mesh& mesh) {
    const Sight sight(mesh.triangles, mesh.positions, Marks(mesh.triangles.size()));
    std::vector<TriangleId> all;
    for (TriangleId t = 0; t < mesh.triangles.size(); ++t) all.push_back(t);
    return share_that_bounds(mesh.triangles, mesh.positions, sight, all, 128);
  };
  EXPECT_EQ(bounding(shapes::torus()), 1);
  EXPECT_EQ(bounding(shapes::nested_spheres()), 1);
  EXPECT_EQ(bounding(shapes::inverted(shapes::torus())), 0);
  // The inner one of two, and a body with its back.
  EXPECT_NEAR(bounding(shapes::nested_shells()), 0.8, 0.15);
  EXPECT_EQ(bounding(shapes::merged({shapes::cube(), shapes::inverted(shapes::cube())})), 0);
}

}  // namespace
}  // namespace kdm
