// SPDX-License-Identifier: MIT
// What is thinner or narrower than asked for goes, the rest stays just as it is.
#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "grid/validate.h"
#include "kdmanifold/boolean.h"
#include "kdmanifold/build.h"
#include "kdmanifold/error.h"
#include "kdmanifold/extract.h"
#include "kdmanifold/grid_io.h"
#include "support/mesh_check.h"
#include "support/shapes.h"

namespace kdm {
namespace {

constexpr double kTolerance = 0.005;

// The vessel of the paper's figure 14: closed, with a thin wall all over and a wide mouth.
Mesh vase(double wall) {
  constexpr int kSteps = 24;
  const auto radius = [](double height) { return 0.35 + 0.1 * shapes::sine(5 * height); };
  std::vector<std::pair<double, double>> profile = {{0, 0}};
  for (int k = 0; k <= kSteps; ++k) {
    const double height = 1.0 * k / kSteps;
    profile.emplace_back(radius(height), height);
  }
  for (int k = kSteps; k >= 0; --k) {
    const double height = 1.0 * k / kSteps;
    if (height > wall) profile.emplace_back(radius(height) - wall, height);
  }
  profile.emplace_back(radius(wall) - wall, wall);
  profile.emplace_back(0, wall);
  return shapes::revolved(profile, 48);
}

// Two cubes, a bar 0.04 thick from one to the other, and a loose plate 0.03 thick.
Mesh bridged_cubes() {
  return shapes::merged({shapes::cube(), shapes::translated(shapes::cube(), Vec3(2, 0, 0)),
                         shapes::box(Vec3(0.9, 0.48, 0.48), Vec3(2.1, 0.52, 0.52)),
                         shapes::box(Vec3(0, 0, 2), Vec3(1, 1, 2.03))});
}

Grid plain_grid(const Mesh& mesh) { return build_grid(mesh, {.tolerance = kTolerance}); }

// Says that a thickness and a gap leave everything as it is, to the last bit.
void expect_unchanged(const Mesh& mesh, double thickness, double gap) {
  const Grid grid = build_grid(
      mesh, {.tolerance = kTolerance, .minimum_thickness = thickness, .minimum_gap = gap});
  EXPECT_EQ(save_grid(grid), save_grid(plain_grid(mesh)));
  EXPECT_EQ(grid.stats().thin_area, 0);
  EXPECT_EQ(grid.stats().narrow_area, 0);
}

std::string message_of(const Mesh& mesh, const BuildOptions& options) {
  try {
    build_grid(mesh, options);
  } catch (const Error& error) {
    return error_code_name(error.code()) + std::string(": ") + error.what();
  }
  return "";
}

bool warns(const ExtractedMesh& mesh, const std::string& code) {
  return std::any_of(mesh.warnings.begin(), mesh.warnings.end(),
                     [&](const Warning& warning) { return warning.code == code; });
}

TEST(OpenAndClose, AThinVesselStaysOrVanishesAsAWhole) {
  for (const Mesh& mesh : {vase(0.02), shapes::inverted(vase(0.02))}) {
    expect_unchanged(mesh, 0.015, 0);
    EXPECT_EQ(message_of(mesh, {.tolerance = kTolerance, .minimum_thickness = 0.026}),
              "EMPTY_RESULT: all of the solid is thinner than `minimum_thickness`");
  }
}

// A fine grid's surface has triangles that are folded over and slivers, beside which no ball lies
// inside either.
TEST(OpenAndClose, AVesselVanishesHoweverFineTheGrid) {
  const Mesh thin = vase(0.02);
  const Mesh hollow = shapes::merged(
      {shapes::box(Vec3(-0.6, -0.6, -0.2), Vec3(0.6, 0.6, 1.2)), shapes::inverted(thin)});
  for (const double tolerance : {0.002, 0.001}) {
    SCOPED_TRACE(tolerance);
    for (const double thickness : {0.026, 3.0}) {
      EXPECT_EQ(message_of(thin, {.tolerance = tolerance, .minimum_thickness = thickness}),
                "EMPTY_RESULT: all of the solid is thinner than `minimum_thickness`");
    }
    const Grid filled = build_grid(hollow, {.tolerance = tolerance, .minimum_gap = 0.05});
    EXPECT_EQ(check::check_mesh(extract(filled)).components, 1);
  }
}

TEST(OpenAndClose, ALoosePlateGoesAndABridgeGoes) {
  const Mesh mesh = bridged_cubes();
  expect_unchanged(mesh, 0.02, 0);
  const Grid grid = build_grid(mesh, {.tolerance = kTolerance, .minimum_thickness = 0.06});
  validate(grid.data());
  const ExtractedMesh out = extract(grid);
  const check::MeshCheck found = check::check_mesh(out);
  EXPECT_TRUE(found.two_manifold) << found.faults();
  EXPECT_EQ(out.report.crossings, 0u);
  EXPECT_EQ(found.components, 2);
  EXPECT_EQ(found.euler_characteristic, 4);
  EXPECT_NEAR(found.volume, 2, 1e-3);
  EXPECT_GT(grid.stats().thin_area, 2 + 0.9 * 0.16);
  EXPECT_LT(grid.stats().thin_area, 2.3);
  EXPECT_TRUE(warns(out, "THIN_REMOVED"));
  EXPECT_FALSE(warns(out, "HOLES_CLOSED"));
  EXPECT_FALSE(warns(extract(plain_grid(mesh)), "THIN_REMOVED"));
}

TEST(OpenAndClose, ATurnedCubeStaysAsItIs) {
  expect_unchanged(shapes::rotated(shapes::cube(), Vec3(1, 1, 0.3), 0.7), 0.3, 0.3);
}

TEST(OpenAndClose, NarrowGapsAndHolesAndCavitiesAreFilled) {
  // Two cubes 0.05 apart.
  const Mesh cubes =
      shapes::merged({shapes::cube(), shapes::translated(shapes::cube(), Vec3(1.05, 0, 0))});
  expect_unchanged(cubes, 0, 0.03);
  const Grid joined = build_grid(cubes, {.tolerance = kTolerance, .minimum_gap = 0.1});
  const ExtractedMesh one = extract(joined);
  const check::MeshCheck found = check::check_mesh(one);
  EXPECT_TRUE(found.two_manifold) << found.faults();
  EXPECT_EQ(found.components, 1);
  EXPECT_EQ(found.euler_characteristic, 2);
  EXPECT_GT(found.volume, 2.03);
  EXPECT_LT(found.volume, 2.05);
  EXPECT_GT(joined.stats().narrow_area, 1.5);
  EXPECT_TRUE(warns(one, "GAPS_FILLED"));
  // A cavity 0.05 high.
  const Mesh hollow = shapes::merged(
      {shapes::cube(), shapes::inverted(shapes::box(Vec3(0.2, 0.2, 0.5), Vec3(0.8, 0.8, 0.55)))});
  const ExtractedMesh solid =
      extract(build_grid(hollow, {.tolerance = kTolerance, .minimum_gap = 0.1}));
  EXPECT_EQ(check::check_mesh(solid).components, 1);
  EXPECT_NEAR(check::check_mesh(solid).volume, 1, 1e-3);
}

TEST(OpenAndClose, RefusesWhatCannotBe) {
  EXPECT_EQ(message_of(shapes::cube(), {.inside = InsideRule::kOdd, .minimum_gap = 0.1}),
            "INVALID_OPTION: `minimum_gap`: only with `inside` repair or positive");
  EXPECT_EQ(
      message_of(shapes::cube(), {.strategy = SplitStrategy::kUniform, .minimum_thickness = 0.1}),
      "INVALID_OPTION: `minimum_thickness`: only with `strategy` adaptive, octree or feature");
  EXPECT_EQ(message_of(shapes::cube(), {.minimum_thickness = 0.004}),
            "INVALID_OPTION: `minimum_thickness` is 0.004; for a surface of this area it must be "
            "0.004898979485566357 at least");
  const Mesh cube = shapes::cube();
  EXPECT_THROW(build_csg_grid({cube}, Expression(0), {.minimum_thickness = 0.1}), Error);
}

}  // namespace
}  // namespace kdm
