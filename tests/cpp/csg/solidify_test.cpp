// SPDX-License-Identifier: MIT
// Assemblies: closed parts stay exact beside parts that nothing closes.
#include "csg/solidify.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <string>

#include "grid/validate.h"
#include "kdmanifold/build.h"
#include "kdmanifold/extract.h"
#include "kdmanifold/grid_io.h"
#include "support/mesh_check.h"
#include "support/random.h"
#include "support/sanitized.h"
#include "support/shapes.h"

namespace kdm {
namespace {

Mesh square_at(const Vec3& centre, const Vec3& axis, double angle, double half) {
  Mesh mesh;
  mesh.positions = {Vec3(-half, -half, 0), Vec3(half, -half, 0), Vec3(half, half, 0),
                    Vec3(-half, half, 0)};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return shapes::translated(shapes::rotated(mesh, axis, angle), centre);
}

// The six sides of a cube from the origin, each by itself and moved outwards: nothing sews them.
Mesh loose_walls(double apart) {
  const Mesh cube = shapes::cube();
  std::vector<Mesh> walls;
  for (std::size_t i = 0; i < cube.triangles.size(); i += 2) {
    Mesh wall;
    wall.positions = cube.positions;
    wall.triangles = {cube.triangles[i], cube.triangles[i + 1]};
    const auto& [a, b, c] = wall.triangles[0];
    const Vec3 normal = (wall.positions[b] - wall.positions[a])
                            .cross(wall.positions[c] - wall.positions[a])
                            .normalized();
    walls.push_back(shapes::translated(wall, apart * normal));
  }
  return shapes::merged(walls);
}

struct Built {
  Grid grid;
  ExtractedMesh mesh;
  check::MeshCheck check;
};

Built built(const Mesh& mesh, const BuildOptions& options = {}) {
  Built result{build_grid(mesh, options), {}, {}};
  EXPECT_NO_THROW(validate(result.grid.data()));
  result.mesh = extract(result.grid);
  result.check = check::check_mesh(result.mesh);
  EXPECT_TRUE(result.check.two_manifold) << result.check.faults();
  EXPECT_EQ(result.mesh.report.crossings.value_or(1), 0u);
  return result;
}

bool warns_of(const ExtractedMesh& mesh, const std::string& code) {
  for (const Warning& warning : mesh.warnings) {
    if (warning.code == code) return true;
  }
  return false;
}

TEST(Solidify, SheetsThatCrossBallsLeaveTheBallsExactAndNoCrumbs) {
  check::Random random(3);
  std::vector<Mesh> balls;
  for (int i = 0; i < 4; ++i) {
    balls.push_back(shapes::translated(shapes::icosphere(2, 0.4), Vec3(i, 0, 0)));
  }
  const double volume = check::check_mesh(shapes::merged(balls)).volume;
  std::vector<Mesh> parts = balls;
  for (int i = 0; i < 16; ++i) {
    const double along = random.between(0, 3);
    const Vec3 centre(along, random.between(-0.3, 0.3), 0);
    const Vec3 axis = random.direction();
    parts.push_back(square_at(centre, axis, random.between(0, 3), 0.4));
  }
  const Mesh all = shapes::merged(parts);
  const Built result = built(all);
  EXPECT_EQ(result.check.components, 4);
  EXPECT_EQ(result.check.euler_characteristic, 8);
  EXPECT_NEAR(result.check.volume, volume, 2e-3 * volume);
  const InputReport& input = result.grid.input();
  // Two of them close a corner that lies within a ball.
  EXPECT_EQ(input.lost_parts + input.rebuilt_parts, 16u);
  EXPECT_GE(input.lost_parts, 14u);
  EXPECT_NEAR(input.lost_area, 0.64 * input.lost_parts, 1e-9);
  EXPECT_NEAR(input.largest_lost, 0.64, 1e-9);
  EXPECT_TRUE(warns_of(result.mesh, "PARTS_LOST"));
  EXPECT_FALSE(warns_of(result.mesh, "TOLERANCE_WIDENED"));
  if (check::kSanitized) return;
  // They are kept if they get a thickness.
  const Built thick = built(all, {.thicken = 0.02, .thicken_what = ThickenWhat::kSheets});
  EXPECT_EQ(thick.grid.input().thickened_parts, 16u);
  EXPECT_EQ(thick.grid.input().lost_parts, 0u);
  EXPECT_GT(thick.check.volume, volume + 0.02 * 0.64 * 7);
}

TEST(Solidify, LooseWallsBecomeARoomBesideABallThatStaysExact) {
  const Mesh ball = shapes::translated(shapes::icosphere(3, 0.5), Vec3(3, 0.5, 0.5));
  const double volume = check::check_mesh(ball).volume;
  const Mesh walls = loose_walls(0.1);
  const BuildOptions options{.tolerance = 0.005};
  const Built result = built(shapes::merged({ball, walls}), options);
  const InputReport& input = result.grid.input();
  EXPECT_EQ(input.rebuilt_parts, 6u);
  EXPECT_EQ(input.lost_parts, 0u);
  EXPECT_NEAR(input.rebuilding_tolerance, 0.005, 1e-6);
  EXPECT_GT(result.grid.stats().winding_threshold, 0);
  EXPECT_FALSE(result.grid.stats().topology_resolved);
  EXPECT_EQ(result.check.components, 2);
  // The ball's share is what it is alone.
  const double alone = built(ball, options).check.volume;
  EXPECT_NEAR(alone, volume, 0.01 * volume);
  Mesh room;  // what does not belong to the ball
  room.positions = result.mesh.positions;
  for (const Triangle& t : result.mesh.triangles) {
    if (room.positions[t[0]][0] < 2) room.triangles.push_back(t);
  }
  const double of_room = check::check_mesh(room).volume;
  EXPECT_NEAR(result.check.volume - of_room, volume, 0.01 * volume);
  EXPECT_GT(of_room, 1);
  EXPECT_LT(of_room, 1.8);
}

TEST(Solidify, PartsThatContradictWidenTheToleranceOfNobodyElse) {
  if (check::kSanitized) GTEST_SKIP() << "takes a minute with sanitizers";
  // Scraps without order, which cross each other everywhere.
  check::Random random(7);
  std::vector<Mesh> parts;
  constexpr int kScraps = 3000;
  for (int i = 0; i < kScraps; ++i) {
    const Vec3 centre = random.point(0, 1);
    const Vec3 axis = random.direction();
    parts.push_back(square_at(centre, axis, random.between(0, 3), 0.2));
  }
  const Mesh cube = shapes::rotated(shapes::translated(shapes::cube(), Vec3(3, 0, 0)),
                                    Vec3(1, 2, 3).normalized(), 0.5);
  parts.push_back(cube);
  const Built result = built(shapes::merged(parts), {.relative_tolerance = 0.002});
  const InputReport& input = result.grid.input();
  const GridStats& stats = result.grid.stats();
  EXPECT_NEAR(stats.tolerance, stats.asked_tolerance, 1e-9);
  EXPECT_LE(input.rebuilt_parts + input.lost_parts, static_cast<Index>(kScraps));
  if (input.rebuilding_tolerance > 1.001 * stats.asked_tolerance) {
    EXPECT_TRUE(warns_of(result.mesh, "TOLERANCE_WIDENED"));
  }
  // The cube keeps its corners.
  for (const Vec3& corner : cube.positions) {
    double nearest = 1;
    for (const Vec3& p : result.mesh.positions) nearest = std::min(nearest, (p - corner).norm());
    EXPECT_LT(nearest, stats.tolerance);
  }
}

// Among many other edges nobody sees that they belong together; by themselves they are sewn.
TEST(Solidify, WallsTornApartAreSewnByThemselves) {
  const Mesh ball = shapes::translated(shapes::icosphere(3, 0.5), Vec3(3, 0.5, 0.5));
  const Built result = built(shapes::merged({ball, loose_walls(0.05)}), {.tolerance = 0.005});
  const InputReport& input = result.grid.input();
  EXPECT_EQ(input.rebuilt_parts, 6u);
  EXPECT_EQ(input.sewn_edges, 12u);
  EXPECT_GT(input.sewing_distance, 0.005);
  EXPECT_TRUE(warns_of(result.mesh, "SEWN_FAR"));
  EXPECT_EQ(result.grid.stats().winding_threshold, 0);
  EXPECT_EQ(result.check.components, 2);
}

TEST(Solidify, TheReportOutlivesSaving) {
  const Mesh ball = shapes::translated(shapes::icosphere(2, 0.5), Vec3(3, 0.5, 0.5));
  const Grid grid = build_grid(shapes::merged({ball, loose_walls(0.1)}), {.tolerance = 0.005});
  EXPECT_GT(grid.stats().winding_threshold, 0);
  const Grid loaded = load_grid(save_grid(grid));
  EXPECT_EQ(loaded.input().rebuilt_parts, 6u);
  EXPECT_EQ(loaded.input().rebuilding_tolerance, grid.input().rebuilding_tolerance);
  EXPECT_EQ(loaded.stats().winding_threshold, grid.stats().winding_threshold);
}

TEST(Solidify, AThresholdThatIsGivenDecidesForAllParts) {
  const Mesh ball = shapes::translated(shapes::icosphere(2, 0.5), Vec3(3, 0.5, 0.5));
  const Grid grid = build_grid(shapes::merged({ball, loose_walls(0.05)}),
                               {.tolerance = 0.01, .winding_threshold = 0.5});
  EXPECT_EQ(grid.input().rebuilt_parts, 0u);
  EXPECT_EQ(grid.stats().winding_threshold, 0.5);
}

}  // namespace
}  // namespace kdm
