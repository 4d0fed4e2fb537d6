// SPDX-License-Identifier: MIT
// What a relative tolerance is a fraction of: stray parts do not count.
#include "prepare/extent.h"

#include <gtest/gtest.h>

#include "kdmanifold/build.h"
#include "kdmanifold/extract.h"
#include "kdmanifold/grid_io.h"
#include "support/shapes.h"

namespace kdm {
namespace {

Extent extent_of(const Mesh& mesh) {
  Box bounds{mesh.positions[0], mesh.positions[0]};
  for (const Vec3& p : mesh.positions) {
    bounds.min = bounds.min.cwiseMin(p);
    bounds.max = bounds.max.cwiseMax(p);
  }
  const Topology topology =
      build_topology(mesh.triangles, static_cast<Index>(mesh.positions.size()));
  return find_extent(mesh.triangles, mesh.positions, topology, bounds);
}

Mesh speck(double x) { return shapes::box(Vec3(x, 0, 0), Vec3(x + 0.01, 0.01, 0.01)); }

TEST(Extent, IsTheDiagonalOfAllParts) {
  EXPECT_DOUBLE_EQ(extent_of(shapes::cube()).diagonal, std::sqrt(3));
  const Extent two = extent_of(
      shapes::merged({shapes::cube(), shapes::translated(shapes::cube(), Vec3(9, 0, 0))}));
  EXPECT_DOUBLE_EQ(two.diagonal, std::sqrt(102));
  EXPECT_EQ(two.stray_parts, 0u);
}

TEST(Extent, LeavesStrayPartsOut) {
  for (const double size : {1e-100, 1.0, 1e100}) {
    const Mesh mesh = shapes::scaled(shapes::merged({speck(-50), shapes::cube(), speck(1000)}),
                                     Vec3::Constant(size));
    const Extent extent = extent_of(mesh);
    EXPECT_NEAR(extent.diagonal / size, std::sqrt(3), 1e-9);
    EXPECT_EQ(extent.stray_parts, 2u);
  }
}

TEST(Extent, KeepsSmallPartsThatAreNotFarAway) {
  EXPECT_EQ(extent_of(shapes::merged({shapes::cube(), speck(2)})).stray_parts, 0u);
  EXPECT_EQ(extent_of(shapes::merged({speck(0), speck(50)})).stray_parts, 0u);
}

TEST(Extent, StrayPartsDoNotSetTheTolerance) {
  const Mesh ball = shapes::icosphere(4);
  const Grid grid = build_grid(shapes::merged({ball, speck(500)}));
  EXPECT_EQ(grid.input().stray_parts, 1u);
  EXPECT_NEAR(grid.stats().tolerance, 0.001 * grid.input().extent, 1e-9);
  EXPECT_NEAR(grid.input().extent, 2 * std::sqrt(3), 0.05);
  EXPECT_NEAR(shapes::signed_volume(extract(grid)), shapes::signed_volume(ball), 0.02);
  const Grid loaded = load_grid(save_grid(grid));
  EXPECT_EQ(loaded.input().stray_parts, 1u);
  EXPECT_EQ(loaded.input().extent, grid.input().extent);
}

}  // namespace
}  // namespace kdm
