// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "grid/validate.h"
#include "kdmanifold/boolean.h"
#include "kdmanifold/build.h"
#include "kdmanifold/error.h"
#include "kdmanifold/extract.h"
#include "kdmanifold/grid_io.h"
#include "kdmanifold/simplify.h"
#include "simplify/thickness.h"
#include "support/mesh_check.h"
#include "support/shapes.h"

namespace kdm {
namespace {

using shapes::box;
using shapes::icosphere;
using shapes::inverted;
using shapes::merged;
using shapes::translated;

// So small that what goes would not do so for being near.
constexpr double kNear = 0.003;

check::MeshCheck checked(const Grid& grid) {
  return check::check_mesh(extract(grid, {.strict = Strict::kManifold}));
}

// Simplifies the grid: it must stay valid, also when it is saved, and its surface must have changed
// by what the report says and by nothing else.
SimplifyReport simplified(Grid& grid, const SimplifyOptions& options) {
  const check::MeshCheck before = checked(grid);
  const SimplifyReport report = simplify(grid, options);
  EXPECT_NO_THROW(validate(grid.data()));
  EXPECT_NO_THROW(validate(load_grid(save_grid(grid)).data()));
  const check::MeshCheck after = checked(grid);
  EXPECT_TRUE(after.two_manifold) << after.faults();
  EXPECT_EQ(after.components, before.components - static_cast<int>(report.removed_surfaces));
  EXPECT_EQ(after.euler_characteristic, before.euler_characteristic -
                                            2 * static_cast<int>(report.removed_surfaces) +
                                            2 * static_cast<int>(report.removed_handles));
  return report;
}

// A scene with something thin in it.
struct ThinCase {
  std::string name;
  Mesh mesh;
  double thickness;  // of what is thin
  bool material;
  Index surfaces = 1;
  Index handles = 0;
};

Mesh ball(double radius, const Vec3& at) { return translated(icosphere(3, radius), at); }

std::vector<ThinCase> thin_cases() {
  const Mesh big = icosphere(3);
  const Mesh block = box(Vec3(0, 0, 0), Vec3(1, 1, 1));
  const Mesh bubble = inverted(ball(0.1, Vec3(0.42, 0.47, 0.55)));
  const Mesh ring = shapes::rotated(shapes::torus(0.3, 0.05, 24, 12), Vec3(1, 2, 3), 1);
  const Mesh shell = merged({ball(0.6, Vec3(2, 0, 0)), inverted(ball(0.5, Vec3(2, 0, 0)))});
  return {
      {"ball", merged({big, ball(0.1, Vec3(1.3, 0, 0))}), 0.2, true},
      {"plate", merged({big, shapes::turned(box(Vec3(2, 0, 0), Vec3(3, 1, 0.1)))}), 0.1, true},
      {"bar", merged({big, box(Vec3(-1, -1, 1.2), Vec3(1, -0.9, 1.3))}), 0.1, true},
      {"ring", merged({big, translated(ring, Vec3(1.5, 0, 0))}), 0.1, true, 1, 1},
      {"shell", merged({big, shell}), 0.1, true, 2},
      {"bubble", merged({block, bubble}), 0.2, false},
      {"ring in a block", merged({block, inverted(translated(ring, Vec3(0.5, 0.5, 0.5)))}), 0.1,
       false, 1, 1},
      {"gap in a ball", merged({big, inverted(ball(0.6, Vec3(0, 0, 0))), ball(0.5, Vec3(0, 0, 0))}),
       0.1, false, 2}};
}

SimplifyOptions limits(const ThinCase& c, double thickness) {
  SimplifyOptions options{.surface_error = kNear};
  (c.material ? options.removed_material : options.added_material) = thickness;
  return options;
}

void expect_limits(const ThinCase& c, const Grid& built) {
  SCOPED_TRACE(c.name);
  Grid grid = built;
  const SimplifyReport kept = simplified(grid, limits(c, 0.85 * c.thickness));
  EXPECT_EQ(kept.removed_surfaces, 0u);
  EXPECT_EQ(kept.removed_parts + kept.filled_cavities, 0u);
  grid = built;
  const SimplifyReport report = simplified(grid, limits(c, 1.15 * c.thickness));
  EXPECT_EQ(c.material ? report.removed_parts : report.filled_cavities, 1u);
  EXPECT_EQ(c.material ? report.filled_cavities : report.removed_parts, 0u);
  EXPECT_EQ(report.removed_surfaces, c.surfaces);
  EXPECT_EQ(report.removed_handles, c.handles);
  EXPECT_LT(report.hits, kept.hits);
  EXPECT_LT(report.cells, kept.cells) << "their splits are empty";
}

TEST(ThinRegions, GoIfTheyAreThinEnough) {
  for (const ThinCase& c : thin_cases()) expect_limits(c, build_grid(c.mesh, {.tolerance = 0.01}));
}

// With strips, and grid vertices in what is thin.
TEST(ThinRegions, GoFromUniformGridsToo) {
  const Mesh block = box(Vec3(0, 0, 0), Vec3(1, 1, 1));
  const Mesh small = translated(icosphere(2, 0.2), Vec3(0.5, 0.47, 0.55));
  for (const ThinCase& c :
       {ThinCase{"ball", merged({block, translated(small, Vec3(1, 0, 0))}), 0.38, true},
        ThinCase{"bubble", merged({block, inverted(small)}), 0.38, false}}) {
    expect_limits(c, build_grid(c.mesh, {.strategy = SplitStrategy::kUniform, .depth = 12}));
  }
}

// The other limit, and none, change nothing, to the byte.
TEST(ThinRegions, StayWithoutALimitOfTheirKind) {
  for (const ThinCase& c : thin_cases()) {
    SCOPED_TRACE(c.name);
    Grid grid = build_grid(c.mesh, {.tolerance = 0.01});
    Grid other = grid;
    simplify(grid, {.surface_error = 0.02});
    SimplifyOptions options{.surface_error = 0.02};
    (c.material ? options.added_material : options.removed_material) = 0.09;
    const SimplifyReport report = simplify(other, options);
    EXPECT_EQ(report.removed_surfaces, 0u);
    EXPECT_EQ(save_grid(other), save_grid(grid));
  }
}

// Each by what it is, whatever lies in it: the shell goes, the ball in its cavity stays; and with
// the ball, a cavity in it.
TEST(ThinRegions, AreJudgedOneByOne) {
  const Mesh shell = merged({ball(1, Vec3(0, 0, 0)), inverted(ball(0.9, Vec3(0, 0, 0)))});
  const Mesh within = merged({ball(0.5, Vec3(0, 0, 0)), inverted(ball(0.2, Vec3(0, 0, 0)))});
  const Grid built = build_grid(merged({shell, within}), {.tolerance = 0.005});
  ASSERT_EQ(checked(built).components, 4);
  Grid grid = built;
  SimplifyReport report = simplified(grid, {.surface_error = kNear, .removed_material = 0.15});
  EXPECT_EQ(report.removed_parts, 1u);
  EXPECT_EQ(report.removed_surfaces, 2u);
  EXPECT_LT(checked(grid).volume, 0.6);
  // What is between the shell and the ball becomes one with both.
  grid = built;
  report = simplified(grid, {.surface_error = kNear, .added_material = 0.39});
  EXPECT_EQ(report.filled_cavities, 0u);
  report = simplified(grid, {.surface_error = 2 * kNear, .added_material = 0.5});
  EXPECT_EQ(report.filled_cavities, 2u) << "with the one in the ball";
  EXPECT_EQ(report.removed_surfaces, 3u);
  EXPECT_EQ(report.removed_parts, 0u);
  // Material goes first: nothing is left then to be filled but the cavity in the ball.
  grid = built;
  report =
      simplified(grid, {.surface_error = kNear, .removed_material = 0.15, .added_material = 0.5});
  EXPECT_EQ(report.removed_parts, 1u);
  EXPECT_EQ(report.filled_cavities, 1u);
  EXPECT_NEAR(checked(grid).volume, 4.18879 * 0.125, 0.03);
}

// What is thin about a body that is not stays: a bar between two blocks, a tunnel, the gap between
// two plates.
TEST(ThinRegions, AreNotParts) {
  const Mesh block = box(Vec3(0, 0, 0), Vec3(1, 1, 1));
  const Mesh bar = box(Vec3(0.5, 0.47, 0.47), Vec3(2.5, 0.52, 0.52));
  const Mesh beam = box(Vec3(0.47, 0.47, -1), Vec3(0.52, 0.52, 2));
  const std::vector<Grid> grids{
      build_grid(merged({block, translated(block, Vec3(2, 0, 0)), bar}), {.tolerance = 0.01}),
      build_csg_grid({block, beam}, difference(0, 1), {.tolerance = 0.01}),
      build_grid(
          merged({box(Vec3(0, 0, 0), Vec3(1, 1, 0.6)), box(Vec3(0, 0, 0.65), Vec3(1, 1, 1.3))}),
          {.tolerance = 0.01})};
  for (const Grid& built : grids) {
    Grid grid = built;
    const check::MeshCheck before = checked(grid);
    const SimplifyReport report =
        simplified(grid, {.surface_error = kNear, .removed_material = 0.5, .added_material = 0.5});
    EXPECT_EQ(report.removed_surfaces, 0u);
    const check::MeshCheck after = checked(grid);
    EXPECT_EQ(after.components, before.components);
    EXPECT_EQ(after.euler_characteristic, before.euler_characteristic);
    EXPECT_NEAR(after.volume, before.volume, 0.02);
  }
}

// The distance holds for what is left, and nothing of it has gone.
TEST(ThinRegions, LeaveTheRestWithinTheDistance) {
  const Mesh big = icosphere(3);
  Grid alone = build_grid(big, {.tolerance = 0.005});
  Grid both = build_grid(merged({big, ball(0.1, Vec3(1.3, 0, 0))}), {.tolerance = 0.005});
  const SimplifyReport report = simplified(both, {.surface_error = 0.01, .removed_material = 0.25});
  EXPECT_EQ(report.removed_parts, 1u);
  EXPECT_GT(report.removed_splits, 0u);
  EXPECT_EQ(report.allowed_error, 0.01);
  simplify(alone, {.surface_error = 0.01});
  EXPECT_NEAR(checked(both).volume, checked(alone).volume, 0.01 * 12.6);
}

// Such parts have no cells.
TEST(ThinRegions, AreTakenOutOfExactPartsToo) {
  const Mesh plate = box(Vec3(0, 0, 0), Vec3(1, 1, 0.005));
  const Mesh other = box(Vec3(0, 0, 2), Vec3(1, 1, 2.01));
  Grid grid = build_grid(
      merged({translated(plate, Vec3(2, 0, 0)), icosphere(2), translated(other, Vec3(2, 0, 0))}),
      {.tolerance = 0.01});
  ASSERT_EQ(grid.stats().exact_parts, 2u);
  const SimplifyReport report =
      simplified(grid, {.surface_error = kNear, .removed_material = 0.007});
  EXPECT_EQ(report.removed_parts, 1u);
  EXPECT_EQ(grid.stats().exact_parts, 1u);
  EXPECT_EQ(grid.stats().exact_triangles, 12u);
  EXPECT_EQ(simplified(grid, {.surface_error = kNear, .removed_material = 0.02}).removed_parts, 1u);
  EXPECT_EQ(grid.stats().exact_parts, 0u);
}

// Nothing is left of a result that would be empty: the grid is what it was.
TEST(ThinRegions, AreNotAll) {
  for (const Mesh& mesh : {icosphere(2), box(Vec3(0, 0, 0), Vec3(1, 1, 0.005))}) {
    Grid grid = build_grid(mesh, {.tolerance = 0.01});
    const std::vector<std::uint8_t> before = save_grid(grid);
    try {
      simplify(grid, {.surface_error = 0.05, .removed_material = 2.1});
      FAIL();
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::kEmptyResult);
      EXPECT_STREQ(error.what(), "all of the solid is thinner than `removed_material`");
    }
    EXPECT_EQ(save_grid(grid), before);
  }
}

// Needles that grid edges meet here and there leave pillows, which are nothing that is left.
TEST(ThinRegions, AreAllIfPillowsAreLeft) {
  std::vector<Mesh> parts{box(Vec3(0, 0, 0), Vec3(1, 1, 1))};
  for (int i = 0; i < 12; ++i) {
    const Mesh needle = shapes::turned(box(Vec3(0, 0, 0), Vec3(0.02, 0.02, 1)));
    parts.push_back(translated(needle, Vec3(1.5 + 0.13 * i, 0.07 * i, 0)));
  }
  Grid grid = build_grid(merged(parts), {.strategy = SplitStrategy::kUniform, .depth = 12});
  ASSERT_GT(extract(grid, {.strict = Strict::kManifold}).report.dropped_pillows, 0u);
  const std::vector<std::uint8_t> before = save_grid(grid);
  try {
    simplify(grid, {.surface_error = 0.05, .removed_material = 1.1});
    FAIL();
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(), "all of the solid is thinner than `removed_material`");
  }
  EXPECT_EQ(save_grid(grid), before);
}

TEST(ThinRegions, AreNoMatterOfSheets) {
  Grid grid = build_grid(icosphere(2), {.tolerance = 0.02, .inside = InsideRule::kSheet});
  const std::vector<std::uint8_t> before = save_grid(grid);
  for (const SimplifyOptions& options :
       {SimplifyOptions{.surface_error = 0.05, .removed_material = 0.1},
        SimplifyOptions{.surface_error = 0.05, .added_material = 0.1}}) {
    try {
      simplify(grid, options);
      FAIL();
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::kInvalidOption);
    }
    EXPECT_EQ(save_grid(grid), before);
  }
}

// Also when the distance is used up, and with a limit that is larger.
TEST(ThinRegions, GoInAnyCall) {
  const Mesh scene = merged({icosphere(3), ball(0.1, Vec3(1.3, 0, 0)), ball(0.2, Vec3(0, 1.5, 0))});
  Grid grid = build_grid(scene, {.tolerance = 0.005});
  const SimplifyOptions small{.surface_error = 0.01, .removed_material = 0.25};
  SimplifyOptions large = small;
  large.removed_material = 0.45;
  EXPECT_EQ(simplified(grid, small).removed_parts, 1u);
  const std::vector<std::uint8_t> once = save_grid(grid);
  EXPECT_EQ(simplified(grid, small).removed_parts, 0u);
  EXPECT_EQ(save_grid(grid), once);
  const SimplifyReport report = simplified(grid, large);
  EXPECT_EQ(report.removed_parts, 1u);
  EXPECT_EQ(report.removed_splits, 0u);
  EXPECT_EQ(report.allowed_error, 0.01);
  EXPECT_EQ(checked(grid).components, 1);
}

TEST(ThinRegions, LeaveTheGridAloneIfStopped) {
  Grid grid = build_grid(thin_cases()[0].mesh, {.tolerance = 0.02});
  const std::vector<std::uint8_t> before = save_grid(grid);
  const SimplifyOptions options{
      .surface_error = 0.02, .removed_material = 0.3, .added_material = 0.3};
  int calls = 0;
  const auto count = [&](double, std::string_view) { return ++calls > 0; };
  Grid done = grid;
  EXPECT_EQ(simplify(done, options, count).removed_parts, 1u);
  ASSERT_GT(calls, 5);
  for (int last = 1; last <= calls; ++last) {
    int left = last;
    const auto stop = [&](double, std::string_view) { return --left > 0; };
    EXPECT_THROW(simplify(grid, options, stop), Error) << last;
    EXPECT_EQ(save_grid(grid), before);
  }
}

// Every part of a scene with hundreds, and of a Boolean operation.
TEST(ThinRegions, GoFromManySurfaces) {
  const Mesh cheese = shapes::swiss_cheese(40);
  Grid grid = build_grid(cheese, {.relative_tolerance = 0.002});
  const int cavities = checked(grid).components - 1;
  ASSERT_GT(cavities, 20);
  const SimplifyReport report = simplified(grid, {.surface_error = kNear, .added_material = 1});
  EXPECT_EQ(report.filled_cavities, static_cast<Index>(cavities));
  EXPECT_EQ(checked(grid).components, 1);

  const Mesh block = box(Vec3(0, 0, 0), Vec3(1, 1, 1));
  const Mesh slot = box(Vec3(0.4, -1, -1), Vec3(1.95, 2, 2));
  const Mesh both = merged({block, box(Vec3(1.9, 0, 0), Vec3(2, 1, 1))});
  Grid cut = build_csg_grid({both, slot}, difference(0, 1), {.tolerance = 0.005});
  EXPECT_EQ(simplified(cut, {.surface_error = kNear, .removed_material = 0.06}).removed_parts, 1u);
  EXPECT_EQ(simplified(cut, {.surface_error = kNear, .removed_material = 0.35}).removed_parts, 0u);
}

// Not as thick as they are wide.
TEST(ThinRegions, AreAsThickAsTheirLargestBall) {
  const auto triangles = [](const Mesh& mesh) {
    std::vector<std::array<Vec3, 3>> all;
    for (const Triangle& t : mesh.triangles) {
      all.push_back({mesh.positions[t[0]], mesh.positions[t[1]], mesh.positions[t[2]]});
    }
    return all;
  };
  const auto thin = [&](const Mesh& mesh, double thickness) {
    return is_thin(triangles(mesh), thickness);
  };
  const Mesh cube = box(Vec3(0, 0, 0), Vec3(1000, 1000, 1000));
  EXPECT_TRUE(thin(cube, 1000));
  EXPECT_FALSE(thin(cube, 999));
  EXPECT_TRUE(thin(shapes::rotated(cube, Vec3(1, 2, 3), 1), 1000.001));
  EXPECT_FALSE(thin(shapes::rotated(cube, Vec3(1, 2, 3), 1), 990));
  // Two walls that meet at a right angle: where they do, there is room for a ball of 117.2.
  const Mesh angle =
      shapes::scaled(shapes::voxels(5, 5, 5, [](int x, int y, int) { return x == 0 || y == 0; }),
                     Vec3(100, 100, 100));
  EXPECT_FALSE(thin(angle, 115));
  EXPECT_TRUE(thin(angle, 122));
  const Mesh ring = shapes::torus(1000, 100, 64, 32);
  EXPECT_FALSE(thin(ring, 195));
  EXPECT_TRUE(thin(ring, 205));
}

}  // namespace
}  // namespace kdm
