// SPDX-License-Identifier: MIT
// What a result lacks is found, told apart from what the inside rule drops, and distances are
// right.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <vector>

#include "account/triangle_set.h"
#include "kdmanifold/kdmanifold.h"
#include "mesh/spread.h"
#include "support/random.h"
#include "support/random_meshes.h"
#include "support/shapes.h"

namespace kdm {
namespace {

Account account_of(const Mesh& input, const BuildOptions& options = {}) {
  const Grid grid = build_grid(input, options);
  return compare(input, grid, extract(grid), {.error = true});
}

TEST(Compare, NothingIsLostOfWhatComesOutWhole) {
  for (const Mesh& mesh : {shapes::cube(), shapes::rotated(shapes::stairs(3), Vec3(1, 2, 3), 0.7),
                           shapes::icosphere(4), shapes::torus(), shapes::nested_spheres(),
                           shapes::thin_walled_box(0.01)}) {
    const Grid grid = build_grid(mesh);
    const Account account = compare(mesh, grid, extract(grid), {.error = true});
    EXPECT_EQ(account.lost.area, 0);
    EXPECT_EQ(account.lost.parts, 0u);
    EXPECT_EQ(account.lost.inner_area, 0);
    EXPECT_TRUE(account.lost.faces.empty());
    for (const Deviation& d : {account.error->to_input, account.error->to_output}) {
      EXPECT_LE(d.largest, 2 * grid.stats().tolerance);
      EXPECT_LE(d.rms, d.largest);
    }
  }
  EXPECT_FALSE(compare(shapes::cube(), build_grid(shapes::cube()), shapes::cube()).error);
}

TEST(Compare, DistancesAreThoseOfThePlacesThatLieFurthestApart) {
  const Mesh cube = shapes::cube();
  const Grid grid = build_grid(cube);
  const Mesh moved = shapes::translated(cube, Vec3(0.001, 0, 0));
  const MeshError error = *compare(cube, grid, moved, {.error = true}).error;
  for (const Deviation& d : {error.to_input, error.to_output}) {
    EXPECT_NEAR(d.largest, 0.001, 1e-12);
    EXPECT_NEAR(d.rms, 0.001 * std::sqrt(1.0 / 3), 0.00001);  // two of six sides
  }
  // A spike of the input is missed by its height, a spike of the result sticks out by it.
  Mesh spiked = shapes::subdivided(shapes::subdivided(cube));
  Vec3* const middle = &*std::find_if(spiked.positions.begin(), spiked.positions.end(),
                                      [](auto& p) { return p == Vec3(0.5, 0.5, 1); });
  middle->z() += 0.003;
  EXPECT_NEAR(compare(spiked, grid, cube, {.error = true}).error->to_output.largest, 0.003, 1e-9);
  EXPECT_NEAR(compare(cube, grid, spiked, {.error = true}).error->to_input.largest, 0.003, 1e-9);
}

std::vector<std::string> codes_of(const Account& account) {
  std::vector<std::string> codes;
  for (const Warning& warning : account.warnings) codes.push_back(warning.code);
  return codes;
}

// Far, but not so far that the surface counts as lost.
TEST(Compare, WarnsOfResultsBeyondTheTolerance) {
  const Mesh cube = shapes::rotated(shapes::cube(), Vec3(1, 2, 3), 0.7);
  const Grid grid = build_grid(cube);
  const double tolerance = grid.stats().tolerance;
  const auto warnings_at = [&](double tolerances) {
    const Mesh moved = shapes::translated(cube, tolerances * tolerance * Vec3(0, 0, 1));
    return codes_of(compare(cube, grid, moved, {.error = true}));
  };
  const std::vector<std::string> far = {"FAR_FROM_INPUT"};
  EXPECT_TRUE(warnings_at(1.4).empty());
  EXPECT_EQ(warnings_at(1.6), far);
  EXPECT_EQ(warnings_at(3), far);
  EXPECT_EQ(warnings_at(8), (std::vector<std::string>{"AREA_LOST", "FAR_FROM_INPUT"}));
  const Mesh moved = shapes::translated(cube, 3 * tolerance * Vec3(0, 0, 1));
  EXPECT_TRUE(compare(cube, grid, moved).warnings.empty()) << "not measured";
}

// A hole that was closed is far from the input, and a plate as far as it is thick.
TEST(Compare, DoesNotWarnOfWhatWasAskedFor) {
  const Mesh open = shapes::open(shapes::subdivided(shapes::subdivided(shapes::cube())), 32);
  const Account closed = account_of(open, {.inside = InsideRule::kRepair});
  EXPECT_GT(closed.error->to_input.largest, 0.2);
  EXPECT_TRUE(codes_of(closed).empty());
  EXPECT_TRUE(codes_of(account_of(shapes::open(shapes::cube(), 6), {.thicken = 0.1})).empty());
}

TEST(Compare, NumbersDoNotDependOnTheScale) {
  const Mesh mesh = shapes::icosphere(3);
  // In 64 bits at every scale: 32 bits do not hold these.
  const auto error_at = [&](double scale) {
    const Mesh input = shapes::scaled(mesh, Vec3::Constant(scale));
    const Grid grid = build_grid(input);
    const Mesh result = extract(grid, {.strict = Strict::kManifold});
    return *compare(input, grid, result, {.error = true}).error;
  };
  const MeshError error = error_at(1);
  for (const double scale : {0x1p-300, 0x1p300}) {
    const MeshError other = error_at(scale);
    EXPECT_EQ(other.to_input.largest, scale * error.to_input.largest);
    EXPECT_EQ(other.to_output.rms, scale * error.to_output.rms);
  }
}

TEST(Compare, AnEmptyResultIsInfinitelyFarAway) {
  const Grid grid = build_grid(shapes::cube());
  const Account account = compare(shapes::cube(), grid, Mesh(), {.error = true});
  EXPECT_TRUE(std::isinf(account.error->to_output.largest));
  EXPECT_TRUE(std::isinf(account.error->to_input.rms));
  EXPECT_NEAR(account.lost.share, 1, 1e-12);
  EXPECT_NEAR(account.lost.area, 6, 1e-12);
  EXPECT_EQ(account.lost.parts, 1u);
  EXPECT_EQ(account.lost.faces.size(), 12u);
}

TEST(Compare, APartThatIsMissingIsLost) {
  const Mesh near = shapes::cube();
  const Mesh far = shapes::translated(shapes::cube(), Vec3(3, 0, 0));
  const Mesh both = shapes::merged({near, far});
  const Grid grid = build_grid(both);
  for (const Mesh& input : {both, shapes::soup(both), shapes::subdivided(both)}) {
    const LostArea lost = compare(input, grid, near).lost;
    EXPECT_NEAR(lost.area, 6, 1e-9);
    EXPECT_NEAR(lost.largest, 6, 1e-9);
    EXPECT_NEAR(lost.share, 0.5, 1e-9);
    EXPECT_EQ(lost.parts, 1u);
    std::vector<Index> second(input.triangles.size() / 2);
    std::iota(second.begin(), second.end(), static_cast<Index>(second.size()));
    EXPECT_EQ(lost.faces, second);
  }
}

TEST(Compare, CopiesOfLostFacesCountOnce) {
  const Mesh near = shapes::cube();
  const Mesh far = shapes::translated(shapes::cube(), Vec3(3, 0, 0));
  const Mesh input = shapes::merged({near, far, shapes::inverted(far), far});
  const LostArea lost = compare(input, build_grid(shapes::merged({near, far})), near).lost;
  EXPECT_NEAR(lost.area, 6, 1e-9);
  EXPECT_EQ(lost.parts, 1u);
  EXPECT_EQ(lost.faces.size(), 36u);
}

TEST(Compare, PiecesThatTouchNowhereCountApart) {
  std::vector<Mesh> boxes = {shapes::cube()};
  for (int i = 1; i < 4; ++i) {
    boxes.push_back(shapes::box(Vec3(2 * i, 0, 0), Vec3(2 * i + 0.1 * i, 1, 1)));
  }
  const Mesh input = shapes::merged(boxes);
  const LostArea lost = compare(input, build_grid(input), shapes::cube()).lost;
  EXPECT_EQ(lost.parts, 3u);
  EXPECT_NEAR(lost.largest, 2 + 4 * 0.3, 1e-9);
  EXPECT_NEAR(lost.area, 3 * 2 + 4 * (0.1 + 0.2 + 0.3), 1e-9);
}

// Half of a large face is missing: the area is known as well as points lie densely.
TEST(Compare, FacesMayBeLostInPart) {
  const Mesh input = shapes::box(Vec3(0, 0, 0), Vec3(2, 1, 1));
  const LostArea lost = compare(input, build_grid(input), shapes::cube()).lost;
  EXPECT_NEAR(lost.area, 1 + 4, 0.05);
  EXPECT_EQ(lost.parts, 1u);
}

// Walls within the union are dropped as they should be.
TEST(Compare, InnerWallsAreNotLost) {
  const Account account = account_of(shapes::overlapping_cubes());
  EXPECT_EQ(account.lost.area, 0);
  EXPECT_NEAR(account.lost.inner_area, 1.5, 0.1);
  EXPECT_LT(account.error->to_output.largest, 0.02) << "the walls do not count";
  // Nor where they are nearer to the surface than what is missing.
  const Mesh within = shapes::box(Vec3::Constant(0.03), Vec3::Constant(0.97));
  const Account near = account_of(shapes::merged({shapes::cube(), within}), {.tolerance = 0.01});
  EXPECT_EQ(near.lost.inner_area, 0);
  EXPECT_LT(near.error->to_output.largest, 0.015);
  const Account shells = account_of(shapes::nested_shells());
  EXPECT_EQ(shells.lost.area, 0);
  EXPECT_GT(shells.lost.inner_area, 1);
  // By the rule for odd numbers they bound something.
  EXPECT_EQ(account_of(shapes::overlapping_cubes(), {.inside = InsideRule::kOdd}).lost.inner_area,
            0);
  // With their backs, faces do not tell by themselves which side of them is inside.
  Mesh doubled = shapes::overlapping_cubes();
  for (std::size_t i = 0, count = doubled.triangles.size(); i < count; ++i) {
    const Triangle t = doubled.triangles[i];
    doubled.triangles.push_back({t[0], t[2], t[1]});
  }
  const Account two_sided = account_of(doubled);
  EXPECT_EQ(two_sided.lost.area, 0);
  EXPECT_NEAR(two_sided.lost.inner_area, 3, 0.2);
}

TEST(Compare, ACavityThatIsFilledIsLost) {
  const Mesh outer = shapes::box(Vec3(0, 0, 0), Vec3(1, 1, 1));
  const Mesh inner = shapes::inverted(shapes::box(Vec3(0.3, 0.3, 0.3), Vec3(0.7, 0.7, 0.7)));
  const Mesh input = shapes::merged({outer, inner});
  for (const bool flipped : {false, true}) {
    const Mesh turned = flipped ? shapes::inverted(input) : input;
    const LostArea lost = compare(turned, build_grid(turned), outer).lost;
    EXPECT_NEAR(lost.area, 6 * 0.16, 1e-9);
    EXPECT_EQ(lost.inner_area, 0);
  }
  // Within a surface that is open nobody can tell it from a wall.
  const LostArea open = compare(shapes::open(input), build_grid(input), outer).lost;
  EXPECT_GT(open.area, 0);
}

TEST(Compare, FacesWithoutAreaDoNotCount) {
  Mesh input = shapes::cube();
  input.positions.push_back(Vec3(0.5, 0.5, 90));
  const Index tip = static_cast<Index>(input.positions.size() - 1);
  input.triangles.push_back({0, tip, tip});
  input.triangles.push_back({0, 1, 1});
  const Account account =
      compare(input, build_grid(shapes::cube()), shapes::cube(), {.error = true});
  EXPECT_EQ(account.lost.area, 0);
  EXPECT_LT(account.error->to_output.largest, 1e-9);
}

// A sheet that stands on a closed box bounds nothing: it is left out, and that is told.
TEST(Compare, AFinThatIsLeftOutIsLost) {
  Mesh input = shapes::cube();
  input.positions.insert(input.positions.end(), {Vec3(0.2, 0.5, 1), Vec3(0.8, 0.5, 1),
                                                 Vec3(0.8, 0.5, 1.8), Vec3(0.2, 0.5, 1.8)});
  input.triangles.push_back({8, 9, 10});
  input.triangles.push_back({8, 10, 11});
  const Grid grid = build_grid(input);
  const auto [lost, error, warnings] = compare(input, grid, extract(grid));
  EXPECT_NEAR(lost.area, 0.6 * 0.8, 0.02);
  EXPECT_EQ(lost.faces, (std::vector<Index>{12, 13}));
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_EQ(warnings[0].code, "AREA_LOST");
  // As a sheet all of it is kept.
  EXPECT_EQ(account_of(input, {.inside = InsideRule::kSheet}).lost.area, 0);
}

TEST(Compare, ShellsAreAsFarAwayAsTheyAreThick) {
  Mesh plane;
  plane.positions = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 1, 0), Vec3(0, 1, 0)};
  plane.triangles = {{0, 1, 2}, {0, 2, 3}};
  const Account account = account_of(plane, {.thicken = 0.2});
  EXPECT_EQ(account.lost.area, 0);
  EXPECT_NEAR(account.error->to_input.largest, 0.1 * std::sqrt(2), 0.05);
  EXPECT_NEAR(account.error->to_output.rms, 0.1, 0.02);
}

TEST(Compare, QuadsAndSourceFacesAreTaken) {
  Mesh input = shapes::cube();
  input.source_faces.resize(input.triangles.size());
  for (Index t = 0; t < input.triangles.size(); ++t) input.source_faces[t] = 1000 + t / 2;
  const Grid grid = build_grid(input, {.strategy = SplitStrategy::kUniform, .depth = 12});
  const ExtractedMesh out = extract(grid, {.quads = true});
  ASSERT_FALSE(out.quads.empty());
  const Account account = compare(input, grid, out, {.error = true});
  EXPECT_EQ(account.lost.area, 0);
  EXPECT_LT(account.error->to_input.largest, 1e-5);
}

TEST(Compare, RefusesWhatIsNoMesh) {
  const Grid grid = build_grid(shapes::cube());
  Mesh bad = shapes::cube();
  bad.triangles[3][1] = 8;
  EXPECT_THROW(compare(bad, grid, shapes::cube()), Error);
  EXPECT_THROW(compare(shapes::cube(), grid, bad), Error);
  bad = shapes::cube();
  bad.positions[2].y() = std::nan("");
  EXPECT_THROW(compare(bad, grid, shapes::cube()), Error);
}

TEST(Compare, LoadedGridsServeToo) {
  const Mesh input = shapes::overlapping_cubes();
  const Grid built = build_grid(input);
  const Grid loaded = load_grid(save_grid(built));
  const Account one = compare(input, built, extract(built), {.error = true});
  const Account other = compare(input, loaded, extract(loaded), {.error = true});
  EXPECT_EQ(one.lost.inner_area, other.lost.inner_area);
  EXPECT_EQ(one.error->to_output.rms, other.error->to_output.rms);
}

TEST(Compare, WarnsOfMoreThanASmallShare) {
  const Mesh cube = shapes::cube();
  for (const double side : {0.03, 0.04}) {  // a box with 0.0009 and 0.0016 of the cube's area
    const Mesh small = shapes::box(Vec3(3, 0, 0), Vec3(3 + side, side, side));
    const Mesh input = shapes::merged({cube, small});
    const Account account = compare(input, build_grid(input), cube);
    EXPECT_NEAR(account.lost.area, 6 * side * side, 1e-9);
    EXPECT_EQ(account.lost.faces.size(), 12u);
    EXPECT_EQ(account.warnings.size(), side < 0.035 ? 0u : 1u);
  }
  const Mesh input = shapes::merged({cube, shapes::translated(cube, Vec3(3, 0, 0)),
                                     shapes::box(Vec3(6, 0, 0), Vec3(7, 0.5, 0.5))});
  const std::vector<Warning> warnings = compare(input, build_grid(input), cube).warnings;
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_EQ(warnings[0].code, "AREA_LOST");
  EXPECT_EQ(warnings[0].message,
            "58.6 % of the input's area is missing from the result, in 2 pieces, the largest with "
            "an area of 6");
}

// A sheet within the solid was left out rightly; what else is lost is told all the same.
TEST(Compare, SheetsThatWereLeftOutHideNoOtherLoss) {
  const Mesh cube = shapes::cube();
  const Mesh far = shapes::translated(cube, Vec3(3, 0, 0));
  Mesh input = shapes::merged({cube, far});
  const auto corner = static_cast<Index>(input.positions.size());
  input.positions.insert(input.positions.end(),
                         {Vec3(0.2, 0.5, 0.2), Vec3(0.8, 0.5, 0.2), Vec3(0.8, 0.5, 0.8)});
  input.triangles.push_back({corner, corner + 1, corner + 2});
  const Grid grid = build_grid(input);
  EXPECT_EQ(grid.input().lost_parts, 1u);
  const Account whole = compare(input, grid, extract(grid));
  EXPECT_EQ(whole.lost.area, 0);
  EXPECT_NEAR(whole.lost.inner_area, 0.18, 0.01);
  EXPECT_TRUE(whole.warnings.empty());
  const Account half = compare(input, grid, cube);
  EXPECT_NEAR(half.lost.area, 6, 1e-9);
  EXPECT_EQ(half.warnings.size(), 1u);
}

TriangleSet set_of(const Mesh& mesh) {
  TriangleSet set;
  set.positions = mesh.positions;
  set.triangles = mesh.triangles;
  return set;
}

TEST(TriangleSet, TheNearestTriangleIsFound) {
  const Mesh mesh = shapes::random_tetrahedra(200, 3);
  TriangleSet set = set_of(mesh);
  check::Random random(5);
  for (int i = 0; i < 500; ++i) {
    const Vec3 p = random.point(-1, 2);
    double least = 1e300;
    for (const Triangle& t : mesh.triangles) {
      least = std::min(least, squared_distance(p, mesh.positions[t[0]], mesh.positions[t[1]],
                                               mesh.positions[t[2]]));
    }
    EXPECT_EQ(set.squared_distance(p, 0, static_cast<Index>(i)), least);
    const double enough = set.squared_distance(p, 4 * least, kNone);
    EXPECT_TRUE(least <= enough && enough <= 4 * least);
  }
}

TEST(TriangleSet, TurnsRoundAPointAreCounted) {
  TriangleSet set = set_of(shapes::merged({shapes::icosphere(2), shapes::icosphere(2, 0.5),
                                           shapes::inverted(shapes::icosphere(2, 0.2))}));
  EXPECT_EQ(set.winding(Vec3(0, 0, 0)), 1);
  EXPECT_EQ(set.winding(Vec3(0, 0.35, 0)), 2);
  EXPECT_EQ(set.winding(Vec3(-0.7, 0, 0)), 1);
  EXPECT_EQ(set.winding(Vec3(0.8, 0.8, 0)), 0);
}

TEST(Spread, PutsAsManyPointsAsTheAreaAsksFor) {
  const Mesh mesh = shapes::icosphere(3);
  const TriangleSet set = set_of(mesh);
  double area = 0;
  for (Index t = 0; t < set.size(); ++t) area += set.area_of(t);
  Spread spread(area / 1000);
  int points = 0;
  Vec3 sum = Vec3::Zero();
  for (Index t = 0; t < set.size(); ++t) {
    spread.for_each_point(set.corner(t, 0), set.corner(t, 1), set.corner(t, 2), set.area_of(t),
                          [&](const Vec3& p) {
                            ++points;
                            sum += p;
                          });
  }
  EXPECT_NEAR(points, 1000, 1);
  EXPECT_LT((sum / points).norm(), 0.02);
}

}  // namespace
}  // namespace kdm
