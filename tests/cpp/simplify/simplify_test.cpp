// SPDX-License-Identifier: MIT
#include "kdmanifold/simplify.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "geometry/distance.h"
#include "grid/validate.h"
#include "kdmanifold/boolean.h"
#include "kdmanifold/build.h"
#include "kdmanifold/error.h"
#include "kdmanifold/extract.h"
#include "kdmanifold/grid_io.h"
#include "simplify/split_remover.h"
#include "support/grid_compare.h"
#include "support/mesh_assert.h"
#include "support/mesh_check.h"
#include "support/shapes.h"
#include "support/sheets.h"

namespace kdm {
namespace {

// Returns the grid's own surface, as it is before it is embedded.
ExtractedMesh mesh_of(const Grid& grid) { return extract(grid, {.strict = Strict::kManifold}); }

struct Case {
  std::string name;
  Grid grid;
  double error;
};

Mesh turned_cube() { return shapes::rotated(shapes::cube(), Vec3(1, 1, 0.3), 0.7); }

// Small grids of every kind: adaptive and uniform, with strips, corners and rims, sheets, a Boolean
// operation.
std::vector<Case> cases() {
  std::vector<Case> all;
  const auto add = [&](const char* name, const Mesh& mesh, const BuildOptions& options,
                       double error) {
    all.push_back({name, build_grid(mesh, options), error});
  };
  const Mesh torus = shapes::rotated(shapes::torus(1, 0.3, 24, 12), Vec3(1, 2, 3), 1);
  const Mesh open = shapes::open(shapes::icosphere(2), 20);
  add("torus", torus, {.relative_tolerance = 0.015}, 0.06);
  add("uniform torus", torus, {.strategy = SplitStrategy::kUniform, .depth = 10}, 0.05);
  add("cube", turned_cube(), {.relative_tolerance = 0.002}, 0.02);
  add("uniform cube", shapes::cube(), {.strategy = SplitStrategy::kUniform, .depth = 9}, 0.02);
  add("cubes", shapes::overlapping_cubes(), {.strategy = SplitStrategy::kUniform, .depth = 9},
      0.02);
  add("glass", shapes::glass(0.12), {.relative_tolerance = 0.01}, 0.03);
  add("repaired", open, {.relative_tolerance = 0.02}, 0.05);
  add("sheet", open, {.relative_tolerance = 0.01, .inside = InsideRule::kSheet}, 0.05);
  add("square", shapes::grid_sheet(5, 5, [](double x, double y) { return 0.3 * x * y; }),
      {.strategy = SplitStrategy::kUniform, .depth = 9, .inside = InsideRule::kSheet}, 0.05);
  const Mesh cube = shapes::cube();
  const Mesh ball = shapes::icosphere(2, 0.7);
  all.push_back({"difference",
                 build_csg_grid({cube, ball}, difference(0, 1), {.relative_tolerance = 0.01}),
                 0.03});
  return all;
}

// A manifold with the same topology.
bool is_like(const check::MeshCheck& a, const check::MeshCheck& b) {
  return a.manifold && a.closed == b.closed && a.components == b.components &&
         a.euler_characteristic == b.euler_characteristic && a.boundary_loops == b.boundary_loops;
}

// Every single removal leaves a valid grid, whose surface has the same topology.
TEST(Simplify, KeepsTheGridValidAtEveryStep) {
  for (const Case& c : cases()) {
    SCOPED_TRACE(c.name);
    const GridData& data = c.grid.data();
    const check::MeshCheck before = check::check_mesh(mesh_of(c.grid));
    WorkGrid work(data);
    NearSurface near(work, mesh_of(c.grid), c.error / data.lattice.step);
    SplitRemover remover(work, near, std::numeric_limits<double>::infinity());
    Index removed = 0;
    while (remover.remove_next()) {
      ++removed;
      const GridData now = work.result(c.error);
      ASSERT_NO_THROW(validate(now)) << removed;
      ASSERT_EQ(now.splits(), data.splits() - removed);
      if (removed % 32 != 0) continue;
      const check::MeshCheck after =
          check::check_mesh(mesh_of(Grid(std::make_unique<GridData>(now))));
      ASSERT_TRUE(is_like(after, before)) << after.faults();
    }
    EXPECT_GT(removed, 0u);
    EXPECT_EQ(removed, remover.removed());
  }
}

// Points spread over a mesh: corners, and random points of its triangles.
std::vector<Vec3> points_on(const Mesh& mesh) {
  std::vector<Vec3> points;
  std::mt19937 random(1);
  const auto unit = [&] { return static_cast<double>(random()) / 4294967296.0; };
  for (const Triangle& t : mesh.triangles) {
    std::array<Vec3, 3> c;
    for (int i = 0; i < 3; ++i) {
      const auto& p = mesh.positions[t[i]];
      c[i] = Vec3(p[0], p[1], p[2]);
      points.push_back(c[i]);
    }
    for (int k = 0; k < 3; ++k) {
      const double u = std::sqrt(unit());
      const double v = unit();
      points.push_back((1 - u) * c[0] + u * (1 - v) * c[1] + u * v * c[2]);
    }
  }
  return points;
}

double largest_distance(const Mesh& from, const Mesh& to) {
  double largest = 0;
  for (const Vec3& p : points_on(from)) {
    double least = std::numeric_limits<double>::infinity();
    for (const Triangle& t : to.triangles) {
      std::array<Vec3, 3> c;
      for (int i = 0; i < 3; ++i) {
        const auto& q = to.positions[t[i]];
        c[i] = Vec3(q[0], q[1], q[2]);
      }
      least = std::min(least, squared_distance(p, c[0], c[1], c[2]));
    }
    largest = std::max(largest, least);
  }
  return std::sqrt(largest);
}

// Between the points that are tested, the surface may be a little further off. The worst is the
// uniform torus, so coarse that `extract` adds more vertices than there are loops.
constexpr double kMost = 1.3;

TEST(Simplify, StaysWithinTheDistance) {
  for (Case& c : cases()) {
    SCOPED_TRACE(c.name);
    const Mesh before = mesh_of(c.grid);
    const SimplifyReport report = simplify(c.grid, {.surface_error = c.error});
    const ExtractedMesh after = mesh_of(c.grid);
    EXPECT_GT(report.removed_splits, 0u);
    EXPECT_EQ(report.cells, report.cells_before - 2 * report.removed_splits);
    EXPECT_EQ(report.hits, c.grid.data().hits.size());
    EXPECT_LT(report.hits, report.hits_before);
    EXPECT_EQ(report.allowed_error, c.error);
    EXPECT_LT(after.triangles.size(), before.triangles.size());
    EXPECT_LE(largest_distance(after, before), kMost * c.error);
    EXPECT_LE(largest_distance(before, after), kMost * c.error);
    const check::MeshCheck was = check::check_mesh(before);
    const check::MeshCheck is = check::check_mesh(after);
    EXPECT_TRUE(is_like(is, was)) << is.faults();
  }
}

// Every split that separates no two corners goes, and each corner is met exactly.
TEST(Simplify, MakesACubeOfEightVertices) {
  for (const int depth : {9, 12, 15}) {
    SCOPED_TRACE(depth);
    Grid grid = build_grid(shapes::cube(), {.strategy = SplitStrategy::kUniform, .depth = depth});
    simplify(grid, {.surface_error = 0.02});
    const ExtractedMesh mesh = mesh_of(grid);
    EXPECT_EQ(mesh.triangles.size(), 12u);
    EXPECT_EQ(mesh.positions.size(), 8u);
    EXPECT_NEAR(check::check_mesh(mesh).volume, 1, 1e-5);
  }
}

TEST(Simplify, CallsAddUp) {
  for (Case& c : cases()) {
    SCOPED_TRACE(c.name);
    simplify(c.grid, {.surface_error = c.error});
    const std::vector<std::uint8_t> once = save_grid(c.grid);
    const SimplifyReport again = simplify(c.grid, {.surface_error = c.error});
    EXPECT_EQ(again.removed_splits, 0u);
    EXPECT_EQ(again.allowed_error, c.error);
    EXPECT_EQ(again.hits, again.hits_before);
    EXPECT_EQ(save_grid(c.grid), once);
  }
}

TEST(Simplify, GoesOnWhereTheLastCallStopped) {
  const Mesh ball = shapes::icosphere(3);
  Grid grid = build_grid(ball, {.relative_tolerance = 0.005});
  const Mesh before = mesh_of(grid);
  simplify(grid, {.surface_error = 0.02});
  const SimplifyReport second = simplify(grid, {.surface_error = 0.06});
  EXPECT_GT(second.removed_splits, 0u);
  EXPECT_DOUBLE_EQ(second.allowed_error, 0.06);
  const Mesh after = mesh_of(grid);
  EXPECT_LE(largest_distance(after, before), kMost * 0.06);
  EXPECT_LE(largest_distance(before, after), kMost * 0.06);
}

// The on-metric is a limit beside the distance.
TEST(Simplify, KeepsThePlaneError) {
  const Grid built = build_grid(shapes::icosphere(3), {.relative_tolerance = 0.005});
  Grid grid = built;
  const SimplifyReport loose = simplify(grid, {.surface_error = 0.1});
  ASSERT_GT(loose.plane_error, 0.004);
  grid = built;
  const SimplifyReport tight = simplify(grid, {.surface_error = 0.1, .plane_error = 0.004});
  EXPECT_LE(tight.plane_error, 0.004);
  EXPECT_GT(tight.removed_splits, 0u);
  EXPECT_LT(tight.removed_splits, loose.removed_splits);
}

TEST(Simplify, IsTheSameTwiceAndWhenSaved) {
  for (Case& c : cases()) {
    SCOPED_TRACE(c.name);
    Grid other = c.grid;
    Grid loaded = load_grid(save_grid(c.grid));
    simplify(c.grid, {.surface_error = c.error});
    simplify(other, {.surface_error = c.error});
    simplify(loaded, {.surface_error = c.error});
    const std::vector<std::uint8_t> bytes = save_grid(c.grid);
    EXPECT_EQ(save_grid(other), bytes);
    EXPECT_EQ(save_grid(loaded), bytes);
    loaded = load_grid(bytes);
    check::expect_same(loaded, c.grid);
    EXPECT_EQ(loaded.data().simplified, c.error);
    const Mesh mesh = mesh_of(c.grid);
    const Mesh again = mesh_of(loaded);
    EXPECT_EQ(again.positions, mesh.positions);
    EXPECT_EQ(again.triangles, mesh.triangles);
  }
}

TEST(Simplify, LeavesTheGridAloneIfStopped) {
  Grid grid = build_grid(shapes::icosphere(3), {.relative_tolerance = 0.005});
  const std::vector<std::uint8_t> before = save_grid(grid);
  int calls = 0;
  const auto count = [&](double, std::string_view) { return ++calls > 0; };
  Grid done = grid;
  simplify(done, {.surface_error = 0.05}, count);
  ASSERT_GT(calls, 3);
  for (int last = 1; last <= calls; ++last) {
    int left = last;
    const auto stop = [&](double, std::string_view) { return --left > 0; };
    EXPECT_THROW(simplify(grid, {.surface_error = 0.05}, stop), Error) << last;
    EXPECT_EQ(save_grid(grid), before);
  }
}

TEST(Simplify, RefusesOptions) {
  Grid grid = build_grid(shapes::cube());
  for (const SimplifyOptions& options : {SimplifyOptions{}, SimplifyOptions{.surface_error = -1},
                                         SimplifyOptions{.surface_error = NAN},
                                         SimplifyOptions{.surface_error = 1, .plane_error = -1}}) {
    EXPECT_THROW(simplify(grid, options), Error);
  }
}

// Thin parts are in the grid as they are, and no cell holds them.
TEST(Simplify, LeavesThinPartsAlone) {
  const Mesh plate = shapes::box(Vec3(0, 0, 0), Vec3(1, 1, 0.005));
  Grid alone = build_grid(plate, {.tolerance = 0.01});
  ASSERT_EQ(alone.stats().exact_parts, 1u);
  const Mesh before = mesh_of(alone);
  EXPECT_EQ(simplify(alone, {.surface_error = 0.1}).removed_splits, 0u);
  EXPECT_EQ(mesh_of(alone).positions, before.positions);
  Grid both = build_grid(
      shapes::merged({plate, shapes::translated(shapes::icosphere(3, 1), Vec3(0, 0, 3))}),
      {.tolerance = 0.01});
  ASSERT_EQ(both.stats().exact_parts, 1u);
  EXPECT_GT(simplify(both, {.surface_error = 0.1}).removed_splits, 0u);
  const check::MeshCheck after = check::check_mesh(mesh_of(both));
  EXPECT_TRUE(after.manifold);
  EXPECT_EQ(after.components, 2);
}

}  // namespace
}  // namespace kdm
