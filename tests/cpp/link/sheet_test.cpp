// SPDX-License-Identifier: MIT
// Surfaces that bound no solid come out as manifolds with boundary (paper 2.3.2).
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <map>
#include <set>

#include "grid/validate.h"
#include "kdmanifold/build.h"
#include "kdmanifold/extract.h"
#include "support/extract_any.h"
#include "support/mesh_assert.h"
#include "support/random.h"
#include "support/random_meshes.h"
#include "support/sanitized.h"
#include "support/sheets.h"

namespace kdm {
namespace {

BuildOptions sheet(double relative_tolerance = 0.01) {
  return {.relative_tolerance = relative_tolerance, .inside = InsideRule::kSheet};
}

ExtractedMesh convert(const Mesh& mesh, const BuildOptions& options) {
  const Grid grid = build_grid(mesh, options);
  EXPECT_NO_THROW(validate(grid.data()));
  return extract(grid);
}

double diagonal(const Mesh& mesh) {
  Vec3 min = mesh.positions[0];
  Vec3 max = min;
  for (const Vec3& p : mesh.positions) {
    min = min.cwiseMin(p);
    max = max.cwiseMax(p);
  }
  return (max - min).norm();
}

TEST(Sheet, ASquareComesOutInTwoTriangles) {
  const Mesh square = shapes::grid_sheet(1, 1, [](double, double) { return 0.0; });
  const ExtractedMesh out = convert(square, sheet());
  EXPECT_EQ(out.triangles.size(), 2u);
  ASSERT_TRUE(check::is_manifold(out));
  EXPECT_EQ(out.report.boundary_loops, 1u);
  std::set<std::pair<double, double>> corners;
  for (const Vec3& p : out.positions) {
    EXPECT_NEAR(p.z(), 0, 1e-12);
    corners.emplace(std::round(p.x() * 1e5) / 1e5, std::round(p.y() * 1e5) / 1e5);
  }
  EXPECT_EQ(corners, (std::set<std::pair<double, double>>{{0, 0}, {0, 1}, {1, 0}, {1, 1}}));
}

class OpenShapes : public testing::TestWithParam<shapes::OpenShape> {};

TEST_P(OpenShapes, KeepTheirTopologyAndTheirRims) {
  const shapes::OpenShape& shape = GetParam();
  for (const SplitStrategy strategy : {SplitStrategy::kAdaptive, SplitStrategy::kOctree}) {
    BuildOptions options = sheet(0.005);
    options.strategy = strategy;
    const Grid grid = build_grid(shape.mesh, options);
    ASSERT_NO_THROW(validate(grid.data()));
    EXPECT_TRUE(grid.stats().topology_resolved);
    EXPECT_EQ(grid.input().boundary_loops, static_cast<Index>(shape.loops));
    EXPECT_FALSE(grid.input().flipped);
    const ExtractedMesh out = extract(grid);
    ASSERT_TRUE(check::is_manifold(out)) << shape.name;
    const check::MeshCheck result = check::check_mesh(out);
    EXPECT_EQ(result.components, shape.components) << shape.name;
    EXPECT_EQ(result.boundary_loops, shape.loops) << shape.name;
    EXPECT_EQ(result.euler_characteristic, shape.euler) << shape.name;
    EXPECT_EQ(out.report.boundary_loops, static_cast<Index>(shape.loops)) << shape.name;
    if (check::kSanitized) continue;  // what follows is all the test's own work
    const double allowed = 1.5 * 0.005 * diagonal(shape.mesh);
    EXPECT_LT(check::distance_to(shape.mesh, out), allowed) << shape.name << ", input to result";
    EXPECT_LT(check::distance_to(out, shape.mesh), allowed) << shape.name << ", result to input";
    EXPECT_LT(check::rim_distance_to(shape.mesh, out), allowed) << shape.name << ", rims";
    EXPECT_LT(check::rim_distance_to(out, shape.mesh), allowed) << shape.name << ", rims";
  }
}

TEST_P(OpenShapes, AreManifoldsOnAnyGrid) {
  for (const SplitStrategy strategy : {SplitStrategy::kUniform, SplitStrategy::kMedian}) {
    for (const Pairing pairing : {Pairing::kTrace, Pairing::kHermite}) {
      for (const int depth : {4, 9, 12}) {
        const BuildOptions options = {
            .strategy = strategy, .depth = depth, .inside = InsideRule::kSheet, .pairing = pairing};
        const Grid grid = build_grid(GetParam().mesh, options);
        ASSERT_NO_THROW(validate(grid.data()));
        for (const bool quads : {false, true}) {
          const ExtractedMesh out = check::extract_any(
              grid, {.quads = quads, .strict = quads ? Strict::kManifold : check::kSweepStrict});
          if (out.triangles.empty() && out.quads.empty()) continue;  // a coarse grid may miss it
          ASSERT_TRUE(check::is_manifold(out)) << GetParam().name << ", depth " << depth;
          EXPECT_EQ(out.report.boundary_loops,
                    static_cast<Index>(check::check_mesh(out).boundary_loops));
        }
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Sheet, OpenShapes, testing::ValuesIn(shapes::open_shapes()),
                         [](const auto& shape) { return shape.param.name; });

TEST(Sheet, ClosedSurfacesComeOutAsSolidsDo) {
  for (const Mesh& mesh : {shapes::icosphere(2), shapes::torus(), shapes::swiss_cheese(4)}) {
    BuildOptions options = sheet();
    const ExtractedMesh as_sheet = extract(build_grid(mesh, options));
    options.inside = InsideRule::kPositive;
    const ExtractedMesh as_solid = extract(build_grid(mesh, options));
    EXPECT_EQ(as_sheet.positions, as_solid.positions);
    EXPECT_EQ(as_sheet.triangles, as_solid.triangles);
    EXPECT_EQ(as_sheet.report.boundary_loops, 0u);
  }
}

TEST(Sheet, NothingIsTurnedRound) {
  const Mesh ball = shapes::inverted(shapes::icosphere(2));
  const ExtractedMesh out = convert(ball, sheet());
  EXPECT_LT(check::check_mesh(out).volume, -4);
}

TEST(Sheet, NestedAndCrossingShellsAllStay) {
  const ExtractedMesh nested = convert(shapes::nested_shells(), sheet());
  EXPECT_EQ(check::check_mesh(nested).components, 2);
  const Mesh cubes = shapes::rotated(shapes::overlapping_cubes(), Vec3(1, 2, 3), 0.7);
  const ExtractedMesh crossing = convert(cubes, sheet());
  ASSERT_TRUE(check::is_two_manifold(crossing));
  const check::MeshCheck result = check::check_mesh(crossing);
  EXPECT_EQ(result.components, 2);
  EXPECT_NEAR(result.volume, 2, 0.01) << "what they have in common counts twice";
}

TEST(Sheet, NeighboursTurnedAgainstEachOtherComeApart) {
  // Two squares that share an edge, the second one's normal the other way.
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0.3}, {0, 1, 0.3}, {2, 0, 0.2}, {2, 1, 0.5}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}, {1, 2, 4}, {4, 2, 5}};
  const ExtractedMesh out = convert(mesh, sheet());
  ASSERT_TRUE(check::is_manifold(out));
  EXPECT_EQ(check::check_mesh(out).components, 2);
  EXPECT_EQ(out.report.boundary_loops, 2u);
  EXPECT_LT(check::rim_distance_to(mesh, out), 0.05);
}

TEST(Sheet, AMoebiusBandIsCutOnce) {
  const ExtractedMesh out = convert(shapes::moebius_band(48), sheet());
  ASSERT_TRUE(check::is_manifold(out));
  const check::MeshCheck result = check::check_mesh(out);
  EXPECT_EQ(result.components, 1);
  EXPECT_EQ(result.boundary_loops, 1);
  EXPECT_EQ(result.euler_characteristic, 1) << "a disk";
}

TEST(Sheet, CracksWithinRoundingAreClosed) {
  // The right half's vertices along the seam lie a little off.
  Mesh left = shapes::grid_sheet(6, 12, [](double x, double y) { return 0.2 * x * y; });
  Mesh right = shapes::translated(left, Vec3(1, 1e-7, -1e-7));
  for (Vec3& p : right.positions) p.z() += 0.2 * p.y();
  const Mesh cracked = shapes::merged({left, right});
  EXPECT_EQ(build_grid(cracked, sheet()).input().boundary_loops, 2u);
  const ExtractedMesh out = convert(cracked, sheet());
  ASSERT_TRUE(check::is_manifold(out));
  EXPECT_EQ(check::check_mesh(out).components, 1);
}

TEST(Sheet, RandomSoupIsAManifoldWhateverTheGrid) {
  check::Random random(5);
  for (std::uint32_t seed = 0; seed < (check::kSanitized ? 4 : 12); ++seed) {
    Mesh mesh =
        seed % 2 == 0 ? shapes::random_tetrahedra(12, seed) : shapes::collapsed_polyhedron(3, seed);
    // Some faces go, some turn over, some come twice.
    std::vector<Triangle> triangles;
    for (Triangle t : mesh.triangles) {
      if (random.below(4) == 0) continue;
      if (random.below(5) == 0) std::swap(t[0], t[1]);
      triangles.push_back(t);
      if (random.below(6) == 0) triangles.push_back(t);
    }
    if (triangles.empty()) continue;
    mesh.triangles = triangles;
    for (const SplitStrategy strategy :
         {SplitStrategy::kUniform, SplitStrategy::kMedian, SplitStrategy::kAdaptive}) {
      BuildOptions options = sheet();
      options.strategy = strategy;
      if (strategy == SplitStrategy::kAdaptive) {
        options.relative_tolerance = 0.02;
      } else {
        options.relative_tolerance = BuildOptions().relative_tolerance;
        options.depth = 10;
      }
      const Grid grid = build_grid(mesh, options);
      ASSERT_NO_THROW(validate(grid.data())) << "seed " << seed;
      const ExtractedMesh out = check::extract_any(grid, {.strict = check::kSweepStrict});
      if (out.triangles.empty()) continue;
      ASSERT_TRUE(check::is_manifold(out)) << "seed " << seed;
      const MeshReport report = describe(out);
      EXPECT_TRUE(report.manifold);
      EXPECT_EQ(report.boundary_loops, out.report.boundary_loops);
    }
  }
}

}  // namespace
}  // namespace kdm
