// SPDX-License-Identifier: MIT
// Vertex splits: exhaustively on small rings, and on leaves that hold several features.
#include "extract/place/split_vertices.h"

#include <gtest/gtest.h>

#include <limits>

#include "extract/mend/double_edges.h"
#include "extract/place/place.h"
#include "kdmanifold/build.h"
#include "kdmanifold/error.h"
#include "kdmanifold/extract.h"
#include "support/dual_mesh_check.h"
#include "support/dual_mesh_shapes.h"
#include "support/mesh_assert.h"
#include "support/sanitized.h"
#include "support/shapes.h"

namespace kdm {
namespace {

// --- All small rings -----------------------------------------------------------------------------

constexpr std::int32_t kSize = 64;
constexpr SplitError kError{.distance = 0.01};

// Planes that a ring of polygons may lie in: some meet in one point, some are parallel.
const std::array<Plane, 5> kPlanes{{{Vec3(1, 0, 0), 10},
                                    {Vec3(0, 1, 0), 20},
                                    {Vec3(0, 0, 1), 30},
                                    {Vec3(-1, 0, 0), -50},
                                    {Vec3(0, 0.6, 0.8), 12}}};

// A fan of n triangles round vertex 0 over a ring, closed by a fan round the last vertex. All
// vertices lie in one leaf; triangle i of the fan has plane ring[i].
struct Fan {
  GridData grid;
  DualMesh mesh;
  std::vector<Vec3> points;
  EditLog log;
  std::vector<LoopId> missed;  // the vertices to be split
  std::vector<LatticeBox> boxes{{{0, 0, 0}, {kSize, kSize, kSize}}};

  GridView view() const { return {grid, boxes, points}; }

  explicit Fan(const std::vector<int>& ring) {
    const auto n = static_cast<Index>(ring.size());
    std::vector<Triangle> triangles;
    for (Index i = 0; i < n; ++i) triangles.push_back({0, 1 + i, 1 + (i + 1) % n});
    for (Index i = 0; i < n; ++i) triangles.push_back({n + 1, 1 + (i + 1) % n, 1 + i});
    mesh = shapes::dual_mesh(triangles);
    grid.planes.assign(kPlanes.begin(), kPlanes.end());
    for (Index t = 0; t < 2 * n; ++t) {
      const Index plane = t < n ? static_cast<Index>(ring[t]) : t % 5;
      grid.hits.emplace_back(0u, plane, false, false);
      const Plane& p = grid.planes[plane];
      const Vec3 near(8.0 + 5 * t % 40, 9.0 + 7 * t % 40, 10.0 + 11 * t % 40);
      points.push_back(near - (p.normal.dot(near) - p.offset) * p.normal);
    }
    // Vertices were numbered as leaves; each gets a box of its own number.
    boxes.assign(n + 2, boxes[0]);
    find_loops(grid, mesh);
    missed = place_vertices(view(), {.split_error = kError}, mesh);
  }
};

TEST(SplitVertices, EveryRingOfUpToSixPolygonsStaysASphere) {
  int split = 0;
  for (int n = 3; n <= (check::kSanitized ? 5 : 6); ++n) {
    std::vector<int> ring(n, 0);
    for (;;) {
      Fan fan(ring);
      const auto loops = fan.mesh.vertices();
      const Index triangles = fan.mesh.triangles();
      const Index added =
          split_vertices(fan.view(), {.split_error = kError}, fan.mesh, fan.log, fan.missed);
      ASSERT_EQ(fan.mesh.vertices(), loops + added);
      ASSERT_EQ(fan.mesh.triangles(), triangles + 2 * added);
      ASSERT_EQ(fan.mesh.position.size(), fan.mesh.vertices());
      ASSERT_EQ(fan.mesh.leaf.size(), fan.mesh.vertices());
      check::expect_sound(fan.mesh);
      separate_double_edges(fan.view(), fan.mesh, fan.log);
      const check::MeshCheck result = check::check_mesh(shapes::index_mesh(fan.mesh));
      ASSERT_TRUE(result.two_manifold) << testing::PrintToString(ring) << result.faults();
      ASSERT_EQ(result.euler_characteristic, 2);
      split += added > 0 ? 1 : 0;
      int digit = 0;
      while (digit < n && ++ring[digit] == 5) ring[digit++] = 0;
      if (digit == n) break;
    }
  }
  EXPECT_GT(split, check::kSanitized ? 500 : 1000);
}

// --- Leaves with several features ----------------------------------------------------------------

ExtractedMesh coarse(const Mesh& mesh, SplitStrategy strategy, int depth, double split_error) {
  const Grid grid =
      build_grid(mesh, {.strategy = strategy, .relative_tolerance = 0.001, .depth = depth});
  return extract(grid, {.split_error = split_error});
}

TEST(SplitVertices, ACubeInMedianCellsComesOutExactly) {
  constexpr double kNever = std::numeric_limits<double>::infinity();
  for (const Mesh& cube : {shapes::cube(), shapes::translated(shapes::cube(), Vec3(3, -7, 0.1)),
                           shapes::scaled(shapes::cube(), Vec3(1, 0.7, 0.4))}) {
    const double volume = shapes::signed_volume(cube);
    const ExtractedMesh whole = coarse(cube, SplitStrategy::kMedian, 0, 0);
    EXPECT_GT(whole.report.split_vertices, 0u);
    EXPECT_TRUE(check::is_two_manifold(whole));
    EXPECT_NEAR(shapes::signed_volume(whole), volume, 1e-5 * volume);
    const ExtractedMesh unsplit = coarse(cube, SplitStrategy::kMedian, 0, kNever);
    EXPECT_EQ(unsplit.report.split_vertices, 0u);
    EXPECT_LT(shapes::signed_volume(unsplit), 0.95 * volume) << "corners are lost without splits";
  }
}

// How near the mesh's nearest vertex is.
double distance_to_vertices(const Mesh& mesh, const Vec3& p) {
  double least = std::numeric_limits<double>::infinity();
  for (const Vec3& q : mesh.positions) least = std::min(least, (q - p).norm());
  return least;
}

// Paper fig. 6 and 7: both ends of a hip roof's ridge lie in one leaf, each of whose upright edges
// meets a different side of the roof.
TEST(SplitVertices, BothEndsOfARidgeInOneLeafAreKept) {
  const auto turned = [](double along, double across, double height) {
    return Vec3((along - across) / std::sqrt(2.0), (along + across) / std::sqrt(2.0), height);
  };
  const Vec3 front = turned(0.3, 0, 1);
  const Vec3 back = turned(-0.3, 0, 1);
  Mesh roof;
  roof.positions = {
      front, back, turned(2.3, -2, 0), turned(2.3, 2, 0), turned(-2.3, 2, 0), turned(-2.3, -2, 0)};
  roof.triangles = {{0, 2, 3}, {0, 3, 4}, {0, 4, 1}, {1, 4, 5},
                    {1, 5, 2}, {1, 2, 0}, {2, 5, 4}, {2, 4, 3}};
  ASSERT_GT(shapes::signed_volume(roof), 0);
  // Two grains set the root cube to 8 with its centre at (0.5, 0.5, 0.5): cells of 1 from +-0.5 on.
  const Vec3 corner = Vec3::Constant(4 * (1 - 1.0 / 128));
  const Vec3 grain = Vec3::Constant(0.01);
  const Vec3 centre = Vec3::Constant(0.5);
  const Mesh scene = shapes::merged({roof, shapes::box(centre - corner, centre - corner + grain),
                                     shapes::box(centre + corner - grain, centre + corner)});
  const ExtractedMesh split = coarse(scene, SplitStrategy::kUniform, 9, 0.01);
  const ExtractedMesh never = coarse(scene, SplitStrategy::kUniform, 9, 1e9);
  EXPECT_TRUE(check::is_two_manifold(split));
  for (const Vec3& end : {front, back}) {
    EXPECT_LT(distance_to_vertices(split, end), 1e-4);
    EXPECT_GT(distance_to_vertices(never, end), 0.1);
  }
}

TEST(SplitVertices, CurvatureAloneSplitsNothing) {
  const Mesh sphere = shapes::icosphere(4);
  const ExtractedMesh out = coarse(sphere, SplitStrategy::kUniform, 12, 0);
  EXPECT_EQ(out.report.split_vertices, 0u);
  EXPECT_GT(coarse(sphere, SplitStrategy::kUniform, 12, 1e-3).report.split_vertices, 0u);
}

TEST(SplitVertices, QuadsStayQuads) {
  const Grid grid = build_grid(shapes::cube(), {.strategy = SplitStrategy::kMedian});
  EXPECT_EQ(extract(grid, {.quads = true}).report.split_vertices, 0u);
  EXPECT_GT(extract(grid, {.quads = true, .split_error = 0.01}).report.split_vertices, 0u);
}

TEST(SplitVertices, BadErrorsAreRefused) {
  const Grid grid = build_grid(shapes::cube());
  for (const double error : {-1.0, std::numeric_limits<double>::quiet_NaN()}) {
    try {
      extract(grid, {.split_error = error});
      FAIL() << error;
    } catch (const Error& refused) {
      EXPECT_EQ(refused.code(), ErrorCode::kInvalidOption);
      EXPECT_NE(std::string(refused.what()).find("split_error"), std::string::npos);
    }
  }
}

}  // namespace
}  // namespace kdm
