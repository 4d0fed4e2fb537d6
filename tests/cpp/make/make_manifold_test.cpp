// SPDX-License-Identifier: MIT
// The whole way of a mesh: where results are reduced, that the tolerance holds for the whole, and
// that nothing is refused or left out silently.
#include "kdmanifold/make_manifold.h"

#include <gtest/gtest.h>

#include <set>

#include "kdmanifold/account.h"
#include "kdmanifold/boolean.h"
#include "kdmanifold/error.h"
#include "kdmanifold/grid_io.h"
#include "kdmanifold/thicken.h"
#include "support/mesh_assert.h"
#include "support/mesh_check.h"
#include "support/shapes.h"
#include "support/sheets.h"

namespace kdm {
namespace {

constexpr double kTolerance = 0.02;

MakeOptions within(double tolerance) { return {.build = {.tolerance = tolerance}}; }

Mesh ring() { return shapes::torus(1, 0.3, 24, 12); }

Mesh wave() {
  return shapes::grid_sheet(
      12, 12, [](double x, double y) { return 0.1 * shapes::sine(3 * x) * shapes::cosine(4 * y); });
}

void expect_same(const Mesh& a, const Mesh& b) {
  EXPECT_EQ(a.positions, b.positions);
  EXPECT_EQ(a.triangles, b.triangles);
  EXPECT_EQ(a.quads, b.quads);
  EXPECT_EQ(a.source_faces, b.source_faces);
}

std::string complaint(const MakeOptions& options) {
  try {
    make_manifold(shapes::cube(), options);
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kInvalidOption);
    return error.what();
  }
  return "";
}

TEST(MakeManifold, ReducesWithinTheTolerance) {
  for (const Mesh& mesh :
       {ring(), shapes::overlapping_cubes(), shapes::rotated(shapes::cube(), Vec3(1, 2, 3), 0.7)}) {
    const MadeManifold made = make_manifold(mesh, within(kTolerance));
    EXPECT_TRUE(check::is_two_manifold(made));
    EXPECT_EQ(find_self_intersections(made).pairs, 0u);
    ASSERT_TRUE(made.reduced);
    EXPECT_EQ(made.reduced->triangles, made.triangles.size());
    EXPECT_LT(made.reduced->triangles, made.reduced->triangles_before);
    EXPECT_GT(made.reduced->collapses, 0u);
    // What counts is the surface, so that sides within the solid are not looked for.
    EXPECT_LT(check::distance_to(made, mesh), 1.05 * kTolerance);
    EXPECT_TRUE(made.levels.empty());
  }
}

TEST(MakeManifold, TheAccountSpeaksOfTheToleranceAskedFor) {
  const MadeManifold made = make_manifold(ring(), within(kTolerance));
  EXPECT_EQ(made.stats.asked_tolerance, kTolerance);
  EXPECT_NEAR(made.stats.tolerance, kTolerance, 1e-9);
  EXPECT_EQ(made.grid.stats().asked_tolerance, kTolerance);
  EXPECT_LT(made.grid.stats().tolerance, 0.9 * kTolerance);
  EXPECT_EQ(made.stats.cells, made.grid.stats().cells);

  MakeOptions plain = within(kTolerance);
  plain.reduction.reduce = false;
  const MadeManifold own = make_manifold(ring(), plain);
  EXPECT_NEAR(own.stats.tolerance, kTolerance, 1e-9);
  EXPECT_LT(own.stats.cells, made.stats.cells);
}

TEST(MakeManifold, SewsWithinTheWholeTolerance) {
  // Two halves of a box, 0.8 tolerances apart: more than the grid's share.
  const double gap = 0.8 * kTolerance;
  Mesh left = shapes::box(Vec3(0, 0, 0), Vec3(1, 1, 1));
  Mesh right = shapes::box(Vec3(1 + gap, 0, 0), Vec3(2, 1, 1));
  const auto without_side = [](Mesh mesh, double x) {
    std::erase_if(mesh.triangles, [&](const Triangle& t) {
      return mesh.positions[t[0]].x() == x && mesh.positions[t[1]].x() == x &&
             mesh.positions[t[2]].x() == x;
    });
    return mesh;
  };
  const Mesh torn = shapes::merged({without_side(left, 1), without_side(right, 1 + gap)});
  const MadeManifold made = make_manifold(torn, within(kTolerance));
  EXPECT_EQ(made.grid.input().sewn_edges, 4u);
  EXPECT_EQ(describe(made).components, 1u);
}

TEST(MakeManifold, GivesTheGridsOwnWhereItIsNotToReduce) {
  const Mesh mesh = ring();
  const auto expect_plain = [&](const MakeOptions& options) {
    const MadeManifold made = make_manifold(mesh, options);
    EXPECT_FALSE(made.reduced);
    expect_same(made, extract(build_grid(mesh, options.build), options.extract));
  };
  expect_plain({.build = {.tolerance = kTolerance}, .reduction = {.reduce = false}});
  expect_plain({.build = {.tolerance = kTolerance}, .extract = {.quads = true}});
  expect_plain({.build = {.tolerance = kTolerance}, .extract = {.strict = Strict::kOff}});
  expect_plain({.build = {.strategy = SplitStrategy::kUniform, .depth = 12}});
  expect_plain({.build = {.strategy = SplitStrategy::kMedian}});
  expect_plain({.build = {.strategy = SplitStrategy::kOctree, .cells = 20}});
  expect_plain({.build = {.relative_tolerance = 0, .depth = 12}});
}

TEST(MakeManifold, RefusesToReduceBesideWhatExcludesIt) {
  const ReductionOptions asked{.reduce = true};
  const ReductionOptions numbers{.target_triangles = {100}};
  EXPECT_EQ(complaint({.extract = {.quads = true}, .reduction = asked}),
            "`reduce`: not together with `quads`");
  EXPECT_EQ(complaint({.extract = {.quads = true}, .reduction = numbers}),
            "`target_triangles`: not together with `quads`");
  EXPECT_EQ(complaint({.extract = {.strict = Strict::kOff}, .reduction = asked}),
            "`reduce`: not together with `strict` off");
  EXPECT_EQ(complaint({.build = {.strategy = SplitStrategy::kUniform}, .reduction = asked}),
            "`reduce`: not together with `strategy` uniform");
  EXPECT_EQ(complaint({.build = {.strategy = SplitStrategy::kMedian}, .reduction = numbers}),
            "`target_triangles`: not together with `strategy` median");
  EXPECT_EQ(complaint({.build = {.relative_tolerance = 0}, .reduction = asked}),
            "`reduce`: not together with `relative_tolerance` 0");
  EXPECT_EQ(
      complaint({.build = {.strategy = SplitStrategy::kOctree, .cells = 9}, .reduction = asked}),
      "`reduce`: not together with `cells`");
  EXPECT_EQ(complaint({.reduction = {.reduce = false, .target_triangles = {100}}}),
            "`target_triangles`: not together with `reduce` false");
  EXPECT_EQ(complaint({.reduction = {.target_triangles = {100, 100}}}),
            "target_triangles is 100; it must be a whole number from 1 on, smaller than the one "
            "before");
  EXPECT_EQ(complaint({.build = {.tolerance = -1}}).rfind("tolerance is -1", 0), 0u);
}

TEST(MakeManifold, MakesSeveralLevels) {
  MakeOptions options = within(0.2);
  options.reduction.target_triangles = {400, 320, 260};
  const MadeManifold made = make_manifold(ring(), options);
  ASSERT_EQ(made.levels.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_TRUE(check::is_two_manifold(made.levels[i]));
    EXPECT_LE(made.levels[i].triangles.size(), options.reduction.target_triangles[i]);
    EXPECT_GT(made.levels[i].triangles.size(), options.reduction.target_triangles[i] - 4);
  }
  expect_same(made, made.levels.back());

  // The tolerance counts too.
  options.build.tolerance = 0.005;
  options.reduction.target_triangles = {10};
  EXPECT_GT(make_manifold(ring(), options).triangles.size(), 100u);
}

TEST(MakeManifold, HoldsShellsAgainstThemselves) {
  const double thickness = 0.1;
  const Mesh sheet = wave();
  MakeOptions options = within(kTolerance);
  options.build.thicken = thickness;
  const MadeManifold made = make_manifold(sheet, options);
  EXPECT_TRUE(check::is_two_manifold(made));
  ASSERT_TRUE(made.reduced);
  EXPECT_LT(made.reduced->triangles, made.reduced->triangles_before);
  EXPECT_NEAR(made.stats.tolerance, kTolerance, 1e-9);
  EXPECT_LT(check::distance_to(made, thicken(sheet, thickness)), 1.05 * kTolerance);
}

TEST(MakeManifold, KeepsClosedHolesClosed) {
  const MadeManifold made = make_manifold(shapes::open(shapes::cube(), 2), within(kTolerance));
  EXPECT_TRUE(check::is_two_manifold(made));
  EXPECT_NEAR(describe(made).volume, 1, 0.01);
  ASSERT_EQ(made.warnings.size(), 1u);
  EXPECT_EQ(made.warnings[0].code, "HOLES_CLOSED");
}

TEST(MakeManifold, ReducesSheets) {
  MakeOptions options = within(kTolerance);
  options.build.inside = InsideRule::kSheet;
  const MadeManifold made = make_manifold(wave(), options);
  EXPECT_TRUE(check::is_manifold(made));
  EXPECT_FALSE(describe(made).closed);
  EXPECT_TRUE(made.reduced);
}

TEST(MakeManifold, SaysThatNothingIsLeft) {
  try {
    make_manifold(shapes::icosphere(2, 0.001), {.build = {.tolerance = 10}});
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kEmptyResult);
  }
}

TEST(MakeManifold, TellsItsStepsAndCanBeStopped) {
  std::vector<MakeStep> steps;
  const auto listen = [&](MakeStep step) {
    steps.push_back(step);
    return Progress();
  };
  make_manifold_in_steps(ring(), within(kTolerance), listen);
  EXPECT_EQ(steps, (std::vector{MakeStep::kBuild, MakeStep::kExtract, MakeStep::kReduce}));

  std::set<std::string> phases;
  double last = 0;
  make_manifold(ring(), within(kTolerance), [&](double fraction, std::string_view phase) {
    EXPECT_GE(fraction, last);
    last = fraction;
    phases.emplace(phase);
    return true;
  });
  EXPECT_EQ(last, 1);
  EXPECT_TRUE(phases.count("reduce"));

  for (const char* stopped : {"link", "faces", "reduce"}) {
    try {
      make_manifold(ring(), within(kTolerance),
                    [&](double, std::string_view phase) { return phase != stopped; });
      ADD_FAILURE() << stopped;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::kAborted);
    }
  }
}

TEST(MakeFromGrid, KeepsTheToleranceThatWasAskedFor) {
  const Mesh mesh = ring();
  const MadeManifold made = make_manifold(mesh, within(kTolerance));
  Grid loaded = load_grid(save_grid(made.grid));
  const MadeMesh again = make_from_grid(loaded, {}, {});
  ASSERT_TRUE(again.reduced);
  EXPECT_EQ(again.reduced->triangles_before, made.reduced->triangles_before);
  EXPECT_NEAR(again.stats.tolerance, kTolerance, 1e-9);
  EXPECT_LT(check::distance_to(again, mesh), 1.05 * kTolerance);
  EXPECT_FALSE(make_from_grid(loaded, {}, {.reduce = false}).reduced);
  EXPECT_FALSE(make_from_grid(loaded, {.quads = true}, {}).reduced);
}

TEST(MakeFromGrid, LeavesOtherGridsAloneUnlessAsked) {
  Grid grid = build_grid(ring(), {.tolerance = kTolerance});
  const MadeMesh plain = make_from_grid(grid, {}, {});
  EXPECT_FALSE(plain.reduced);
  expect_same(plain, extract(grid));
  const MadeMesh asked = make_from_grid(grid, {}, {.reduce = true});
  ASSERT_TRUE(asked.reduced);
  EXPECT_NEAR(asked.stats.tolerance, 2 * kTolerance, 1e-9);
  EXPECT_TRUE(asked.warnings.empty());  // that was asked for
  EXPECT_THROW(make_from_grid(grid, {.quads = true}, {.reduce = true}), Error);
}

// The grid that is handed out is the smaller one, and the whole keeps both distances.
TEST(MakeManifold, SimplifiesTheGridOnDemand) {
  constexpr double kError = 0.03;
  MakeOptions options = within(kTolerance);
  const MadeManifold whole = make_manifold(ring(), options);
  options.reduction.simplify = kError;
  const MadeManifold made = make_manifold(ring(), options);
  EXPECT_FALSE(whole.simplified);
  ASSERT_TRUE(made.simplified);
  EXPECT_EQ(made.simplified->cells_before, whole.stats.cells);
  EXPECT_LT(2 * made.simplified->cells, made.simplified->cells_before);
  EXPECT_EQ(made.grid.stats().cells, made.simplified->cells);
  EXPECT_EQ(made.stats.simplified, kError);
  EXPECT_NEAR(made.stats.tolerance, kTolerance, 1e-9);
  EXPECT_TRUE(made.warnings.empty());
  ASSERT_TRUE(made.reduced);
  EXPECT_TRUE(check::is_two_manifold(made));
  EXPECT_LT(check::distance_to(made, ring()), 1.05 * (kTolerance + kError));
  EXPECT_EQ(compare(ring(), made.grid, made).lost.area, 0);

  options.reduction.reduce = false;
  MadeManifold plain = make_manifold(ring(), options);
  EXPECT_FALSE(plain.reduced);
  expect_same(plain, extract(plain.grid));
  // Calls add up: the same distance again leaves the grid as it is.
  EXPECT_EQ(make_from_grid(plain.grid, {}, options.reduction).simplified->removed_splits, 0u);
  EXPECT_EQ(load_grid(save_grid(plain.grid)).stats().simplified, kError);
}

// What goes counts as lost.
TEST(MakeManifold, TakesThinPartsOutOfTheGrid) {
  const Mesh big = shapes::icosphere(3);
  const Mesh both =
      shapes::merged({big, shapes::translated(shapes::icosphere(2, 0.1), Vec3(1.5, 0, 0))});
  MakeOptions options = within(0.01);
  options.reduction.simplify = 0.01;
  options.reduction.remove_material = 0.25;
  const MadeManifold made = make_manifold(both, options);
  ASSERT_TRUE(made.simplified);
  EXPECT_EQ(made.simplified->removed_parts, 1u);
  EXPECT_EQ(check::check_mesh(made).components, 1);
  EXPECT_GT(compare(both, made.grid, made).lost.area, 0.1);
  const auto refusal = [&](const Mesh& mesh) -> std::string {
    try {
      make_manifold(mesh, options);
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  };
  options.reduction.remove_material = 2.5;
  EXPECT_EQ(refusal(both), "all of the solid is thinner than `remove_material`");
  options.build.inside = InsideRule::kSheet;
  EXPECT_EQ(refusal(big), "`remove_material`: not of a sheet, which bounds no material");
}

TEST(MakeManifold, SimplifiesTheGridOfSolids) {
  const Mesh cube = shapes::cube();
  const Mesh ball = shapes::icosphere(3, 0.7);
  MakeOptions options = within(0.005);
  options.reduction.simplify = 0.02;
  const MadeManifold made =
      make_solids_in_steps(difference(0, 1), {Operand(cube), Operand(ball)}, options, {});
  ASSERT_TRUE(made.simplified);
  EXPECT_GT(made.simplified->removed_splits, 0u);
  EXPECT_TRUE(check::is_two_manifold(made));
  EXPECT_EQ(made.grid.operands().size(), 2u);
}

// The distance is tested at points, so that a little more is possible between them.
TEST(ExtractReduced, KeepsADistanceFromTheGridsOwnSurface) {
  const Grid grid = build_grid(ring(), {.tolerance = 0.02});
  const Mesh own = extract(grid, {.strict = Strict::kEmbedded});
  const MadeMesh near = extract_reduced(grid, {}, {.error = 0.02});
  const MadeMesh far = extract_reduced(grid, {}, {.error = 0.05});
  EXPECT_TRUE(check::is_two_manifold(far));
  EXPECT_LT(far.triangles.size(), near.triangles.size());
  EXPECT_LT(near.triangles.size(), own.triangles.size());
  EXPECT_LT(check::distance_to(near, own), 1.15 * 0.02);
  EXPECT_LT(check::distance_to(far, own), 1.15 * 0.05);
  const MadeMesh few = extract_reduced(grid, {}, {.target_triangles = {60}});
  EXPECT_LE(few.triangles.size(), 60u);
  EXPECT_THROW(extract_reduced(grid, {}, {}), Error);
  EXPECT_THROW(extract_reduced(grid, {.quads = true}, {.error = 0.02}), Error);
}

}  // namespace
}  // namespace kdm
