// SPDX-License-Identifier: MIT
// Walls thinner than a cell (paper 3.1.3, fig. 8b and 11): a grid edge that is hit twice keeps both
// hits, so no cell need be as small as the wall is thin.
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "grid/validate.h"
#include "kdmanifold/build.h"
#include "kdmanifold/extract.h"
#include "support/mesh_assert.h"
#include "support/shapes.h"
#include "support/signs_only.h"

namespace kdm {
namespace {

// The cube that the library puts round a shape.
Box root_of(const Mesh& mesh) {
  const Lattice lattice = build_grid(mesh, {.depth = 1}).data().lattice;
  return {lattice.to_model(Vec3::Zero()), lattice.to_model(Vec3::Constant(kLatticeSize))};
}

// Hits that have another one of the other direction next to them on their edge, and no grid vertex
// between them.
Index double_hits(const GridData& grid, double nearer_than) {
  Index count = 0;
  for (EdgeId edge = 0; edge < 4 * grid.splits(); ++edge) {
    for (const HitId h : grid.edge_hits(edge)) {
      if (h == grid.edge_hits(edge).first) continue;
      const double gap =
          real_position(grid.hits[h].position) - real_position(grid.hits[h - 1].position);
      count += gap * grid.lattice.step < nearer_than ? 1 : 0;
    }
  }
  return count;
}

TEST(Thin, APlateOfAMillionthKeepsItsTwoSides) {
  const double thickness = 1e-6;
  const Mesh plate = shapes::box(Vec3::Zero(), Vec3(1, 1, thickness));
  for (const bool turned : {false, true}) {
    const Mesh mesh = turned ? shapes::rotated(plate, Vec3(1, 2, 3), 0.7) : plate;
    for (const SplitStrategy strategy : {SplitStrategy::kUniform, SplitStrategy::kAdaptive}) {
      BuildOptions options{.strategy = strategy};
      if (strategy == SplitStrategy::kUniform) {
        options.depth = 12;
      } else {
        options.relative_tolerance = 0.01;
      }
      const Grid grid = build_grid(mesh, options);
      ASSERT_NO_THROW(validate(grid.data()));
      EXPECT_LT(grid.stats().depth, 22) << "no cell is as small as the plate is thin";
      if (strategy == SplitStrategy::kUniform) {
        EXPECT_GT(double_hits(grid.data(), 4e-6), 0u);
      } else {
        EXPECT_EQ(grid.stats().exact_parts, 1u);
      }
      const ExtractedMesh out = extract(grid);
      ASSERT_TRUE(check::is_two_manifold(out));
      const check::MeshCheck result = check::check_mesh(out);
      EXPECT_EQ(result.components, 1);
      EXPECT_EQ(result.euler_characteristic, 2);
      double area = 0;
      for (const auto& [a, b, c] : out.triangles) {
        area +=
            0.5 *
            (out.positions[b] - out.positions[a]).cross(out.positions[c] - out.positions[a]).norm();
      }
      // All of both sides but for a rim of the tolerance's width, or a cell's.
      EXPECT_GT(area, strategy == SplitStrategy::kUniform ? 1.6 : 1.85);
      EXPECT_LT(area, 2.01);
    }
  }
}

TEST(Thin, ShellsWithoutThicknessAreSheetsOfTwoSides) {
  // Front and back on the same vertices: as a solid it cancels, as a sheet both sides stay.
  Mesh wall;
  wall.positions = {{0, 0, 0}, {1, 0, 0.2}, {1, 1, 0.3}, {0, 1, 0.1}};
  wall.triangles = {{0, 1, 2}, {0, 2, 3}, {2, 1, 0}, {3, 2, 0}};
  const Grid grid = build_grid(
      wall, {.strategy = SplitStrategy::kUniform, .depth = 12, .inside = InsideRule::kSheet});
  ASSERT_NO_THROW(validate(grid.data()));
  EXPECT_EQ(grid.input().boundary_loops, 0u) << "closed, and flat";
  EXPECT_GT(double_hits(grid.data(), 1e-6), 0u) << "two hits at one position";
  const ExtractedMesh out = extract(grid);
  ASSERT_TRUE(check::is_two_manifold(out));
  EXPECT_EQ(check::check_mesh(out).components, 1);
  EXPECT_EQ(check::check_mesh(out).euler_characteristic, 2);
}

TEST(Thin, WallsThatCrossAnEdgeTwiceAreKeptWithoutRefining) {
  // Eight cells an axis, walls of a sixtieth of a cell, wherever they lie.
  for (const double angle : {0.0, 0.3, 0.7}) {
    const Mesh walls = shapes::rotated(shapes::thin_walled_box(), Vec3(1, 2, 3), angle);
    const Grid grid = build_grid(walls, {.strategy = SplitStrategy::kUniform, .depth = 9});
    EXPECT_GT(double_hits(grid.data(), 0.02), 100u);
    const ExtractedMesh out = extract(grid);
    ASSERT_TRUE(check::is_two_manifold(out));
    EXPECT_EQ(check::check_mesh(out).components, 2);
    EXPECT_EQ(check::check_mesh(out).euler_characteristic, 4);
    const Mesh baseline = check::signs_only_contour(walls, root_of(walls), 8);
    EXPECT_LT(baseline.triangles.size(), out.triangles.size() / 5) << "signs see little of them";
  }
}

// Figures 8b and 11: a drinking glass whose wall is a 200th of its height.
TEST(Thin, TheGlassHasNoHoleOnACoarseGrid) {
  const Mesh glass = shapes::glass();
  const double volume = shapes::signed_volume(glass);
  for (const int depth : {12, 13, 14}) {  // 16 to 32 cells an axis
    const ExtractedMesh out =
        extract(build_grid(glass, {.strategy = SplitStrategy::kUniform, .depth = depth}));
    ASSERT_TRUE(check::is_two_manifold(out));
    EXPECT_EQ(check::check_mesh(out).components, 1);
    EXPECT_EQ(check::check_mesh(out).euler_characteristic, 2);
    EXPECT_EQ(out.report.dropped_pillows, 0u);
    // What is missing lies at the rims of foot and bowl: the wall reaches up to a cell less far.
    EXPECT_NEAR(check::check_mesh(out).volume, volume, 0.13 * volume);
  }
  // From signs alone the wall falls to pieces.
  const Mesh baseline = check::signs_only_contour(glass, root_of(glass), 16);
  const check::MeshCheck result = check::check_mesh(baseline);
  EXPECT_FALSE(result.two_manifold && result.components == 1 && result.euler_characteristic == 2);
  RecordProperty("baseline_parts", result.components);
  RecordProperty("baseline_volume_percent", static_cast<int>(100 * result.volume / volume));
}

TEST(Thin, TheGlassIsRightByVolumeWhereItsRimsAreMet) {
  // About as many triangles as 16 cells an axis everywhere take, twice as many in cubes.
  const Mesh glass = shapes::glass();
  const double volume = shapes::signed_volume(glass);
  for (const SplitStrategy strategy : {SplitStrategy::kOctree, SplitStrategy::kAdaptive}) {
    const Grid grid = build_grid(glass, {.strategy = strategy, .relative_tolerance = 0.005});
    EXPECT_TRUE(grid.stats().topology_resolved);
    const ExtractedMesh out = extract(grid);
    ASSERT_TRUE(check::is_two_manifold(out));
    EXPECT_LT(out.triangles.size(), strategy == SplitStrategy::kOctree ? 5000u : 3500u);
    EXPECT_NEAR(check::check_mesh(out).volume, volume, 0.01 * volume);
    EXPECT_EQ(check::check_mesh(out).components, 1);
    EXPECT_EQ(check::check_mesh(out).euler_characteristic, 2);
  }
}

}  // namespace
}  // namespace kdm
