// SPDX-License-Identifier: MIT
// The surface of a box with curves on it.
#include "extract/embed/box_surface.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "kdmanifold/mesh.h"
#include "support/contours.h"
#include "support/mesh_assert.h"
#include "support/shapes.h"

namespace kdm {
namespace {

Mesh mesh_of(const BoxSurface& surface) {
  Mesh mesh;
  mesh.positions = surface.points;
  mesh.triangles = surface.triangles;
  return mesh;
}

// Round corner 0 of a cube, through its three edges, this far from the corner.
void add_ring(double distance, std::vector<Vec3>& points, std::vector<Curve>& curves) {
  Curve curve;
  for (int i = 0; i < 3; ++i) {
    curve.push_back(static_cast<Index>(points.size()));
    points.push_back(distance * Vec3::Unit(i));
  }
  curves.push_back(curve);
}

TEST(BoxSurface, PlainBox) {
  const Vec3 hi(1, 2, 3);
  const auto surface = triangulate_box(Vec3::Zero(), hi, {}, {});
  ASSERT_TRUE(surface);
  EXPECT_EQ(surface->triangles.size(), 12u);
  EXPECT_TRUE(check::is_two_manifold(mesh_of(*surface)));
  EXPECT_NEAR(shapes::signed_volume(mesh_of(*surface)), 6, 1e-12);
}

// +-----+
// |\    |  Three rings round one corner: the cap of each holds those nearer to it.
// |\\   |
// +-----+
TEST(BoxSurface, NestedCapsHaveLevels) {
  std::vector<Vec3> points;
  std::vector<Curve> curves;
  for (const double distance : {2.0, 4.0, 1.0}) add_ring(distance, points, curves);
  const auto surface = triangulate_box(Vec3::Zero(), Vec3::Constant(16), points, curves);
  ASSERT_TRUE(surface);
  EXPECT_EQ(surface->levels, 3);
  EXPECT_EQ(surface->caps[0].level, 2);
  EXPECT_EQ(surface->caps[1].level, 3);
  EXPECT_EQ(surface->caps[2].level, 1);
  EXPECT_EQ(surface->caps[2].triangles.size(), 3u);
  EXPECT_EQ(surface->caps[0].triangles.size(), 9u);
  for (const BoxSurface::Cap& cap : surface->caps) EXPECT_EQ(cap.left, surface->caps[0].left);
}

TEST(BoxSurface, RefusesWhatIsNoSetOfCurves) {
  const Vec3 hi = Vec3::Constant(16);
  std::vector<Vec3> points;
  std::vector<Curve> curves;
  add_ring(4, points, curves);
  add_ring(4, points, curves);
  points[0][0] = 3;  // crosses the other one
  points[1][1] = 5;
  points[2][2] = 3.5;
  EXPECT_FALSE(triangulate_box(Vec3::Zero(), hi, points, curves));
  curves.pop_back();
  points.resize(3);
  EXPECT_TRUE(triangulate_box(Vec3::Zero(), hi, points, curves));
  points[0] += Vec3(0, 1, 1);  // within the box
  EXPECT_FALSE(triangulate_box(Vec3::Zero(), hi, points, curves));
}

TEST(BoxSurface, RandomCurves) {
  std::size_t most = 0;
  int levels = 0;
  for (std::uint32_t seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE(seed);
    const check::Contours input = check::random_contours(2 + static_cast<int>(seed % 3), seed);
    const auto surface = triangulate_box(input.lo, input.hi, input.points, input.curves);
    ASSERT_TRUE(surface);
    const Mesh mesh = mesh_of(*surface);
    ASSERT_TRUE(check::is_two_manifold(mesh));
    EXPECT_EQ(describe(mesh).euler_characteristic, 2);
    EXPECT_EQ(find_self_intersections(mesh).pairs, 0u);
    const double volume = (input.hi - input.lo).prod();
    EXPECT_NEAR(shapes::signed_volume(mesh), volume, 1e-9 * volume);
    most = std::max(most, input.curves.size());
    levels = std::max(levels, surface->levels);
    for (std::size_t c = 0; c < input.curves.size(); ++c) {
      // A cap is a disk, bounded by its curve.
      Mesh cap;
      cap.positions = surface->points;
      for (const Index t : surface->caps[c].triangles) cap.triangles.push_back(mesh.triangles[t]);
      EXPECT_TRUE(check::is_manifold(cap));
      const MeshReport shape = describe(cap);
      EXPECT_EQ(shape.components, 1u);
      EXPECT_EQ(shape.euler_characteristic, 1);
      EXPECT_EQ(shape.boundary_edges, input.curves[c].size());
    }
  }
  EXPECT_GT(most, 5u);
  EXPECT_GE(levels, 2);
}

}  // namespace
}  // namespace kdm
