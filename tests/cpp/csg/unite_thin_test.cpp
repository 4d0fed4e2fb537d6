// SPDX-License-Identifier: MIT
// Thin parts that meet come out in one part, with their thickness.
#include "csg/unite_thin.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "grid/validate.h"
#include "kdmanifold/kdmanifold.h"
#include "support/mesh_assert.h"
#include "support/sanitized.h"
#include "support/shapes.h"

namespace kdm {
namespace {

constexpr double kCoarse = 0.02;
constexpr double kBarWidth = 0.006;  // of a bar

// A bar of square section along x or y.
Mesh thin_bar(int axis, double across, double height) {
  constexpr double a = kBarWidth / 2;
  const Vec3 centre = axis == 0 ? Vec3(0, across, height) : Vec3(across, 0, height);
  const Vec3 half = axis == 0 ? Vec3(1, a, a) : Vec3(a, 1, a);
  return shapes::box(centre - half, centre + half);
}

// Bars along x and along y, `apart` in height: so many of each.
Mesh grating(int bars, double apart) {
  std::vector<Mesh> parts;
  for (int i = 0; i < bars; ++i) {
    const double across = -1 + (2 * i + 1.0) / bars;
    parts.push_back(thin_bar(0, across, 0));
    parts.push_back(thin_bar(1, across, apart));
  }
  return shapes::merged(parts);
}

struct MadeOfBars {
  MadeManifold mesh;
  check::MeshCheck result;

  const InputReport& input() const { return mesh.grid.input(); }
};

MadeOfBars make_bars(const Mesh& mesh, InsideRule inside = InsideRule::kRepair) {
  MakeOptions options;
  options.build.tolerance = kCoarse;
  options.build.inside = inside;
  MadeOfBars made{make_manifold(mesh, options), {}};
  EXPECT_NO_THROW(validate(made.mesh.grid.data()));
  made.result = check::check_mesh(made.mesh);
  EXPECT_TRUE(made.result.two_manifold) << made.result.faults();
  EXPECT_EQ(made.mesh.report.crossings.value_or(1), 0u);
  return made;
}

// Of `bars` in each direction: 2 bars lie in each other at each of their crossings.
void expect_one_grating(const MadeOfBars& made, int bars, double volume_of_crossing) {
  EXPECT_EQ(made.result.components, 1);
  EXPECT_EQ(made.result.euler_characteristic, 2 - 2 * (bars - 1) * (bars - 1));
  const double volume = 4 * bars * kBarWidth * kBarWidth - bars * bars * volume_of_crossing;
  EXPECT_NEAR(made.result.volume, volume, 0.02 * volume);
  const GridStats& stats = made.mesh.stats;
  EXPECT_EQ(stats.exact_parts, 1u);
  EXPECT_EQ(stats.thin_parts, 0u);
  EXPECT_FALSE(stats.topology_resolved) << "where shells cross, nothing proves it";
  EXPECT_EQ(made.input().rebuilt_parts, static_cast<Index>(2 * bars));
  // The mean thickness of a bar is half its width, and a little less for its ends.
  EXPECT_NEAR(made.input().rebuilding_tolerance, kBarWidth / 16, 1e-3 * kBarWidth);
}

TEST(UniteThin, BarsThatCrossBecomeOneGrating) {
  const Mesh crossing = grating(3, 0);
  expect_one_grating(make_bars(crossing), 3, kBarWidth * kBarWidth * kBarWidth);
  if (check::kSanitized) return;
  expect_one_grating(make_bars(shapes::turned(crossing)), 3, kBarWidth * kBarWidth * kBarWidth);
  expect_one_grating(make_bars(crossing, InsideRule::kPositive), 3,
                     kBarWidth * kBarWidth * kBarWidth);
  expect_one_grating(make_bars(grating(3, kBarWidth / 2)), 3,
                     kBarWidth * kBarWidth * kBarWidth / 2);
}

TEST(UniteThin, BarsThatLieOnEachOtherAreJoined) {
  expect_one_grating(make_bars(shapes::turned(grating(2, kBarWidth))), 2, 0);
}

TEST(UniteThin, APartThatCrossesItselfIsItsUnion) {
  // A ring that goes round twice, at two radii which cross.
  constexpr int kSegments = 48;
  Mesh ring;
  for (int i = 0; i < kSegments; ++i) {
    const double angle = 4 * 3.14159265358979 * i / kSegments;
    const double radius = 1 + 0.2 * std::cos(angle / 2);
    for (int k = 0; k < 4; ++k) {
      const double r = radius + kBarWidth / 2 * (k == 1 || k == 2 ? 1 : -1);
      const double z = kBarWidth / 2 * (k < 2 ? -1 : 1);
      ring.positions.emplace_back(r * std::cos(angle), r * std::sin(angle), z);
    }
  }
  for (Index i = 0; i < kSegments; ++i) {
    for (Index k = 0; k < 4; ++k) {
      const Index a = 4 * i + k;
      const Index b = 4 * i + (k + 1) % 4;
      const Index c = (a + 4) % (4 * kSegments);
      const Index d = (b + 4) % (4 * kSegments);
      ring.triangles.push_back({a, c, b});
      ring.triangles.push_back({b, c, d});
    }
  }
  if (shapes::signed_volume(ring) < 0) ring = shapes::inverted(ring);
  const MadeOfBars made = make_bars(ring);
  EXPECT_EQ(made.result.components, 1);
  EXPECT_EQ(made.result.euler_characteristic, -2) << "an eight has two handles";
  EXPECT_NEAR(made.result.volume, shapes::signed_volume(ring), 0.05 * made.result.volume);
  EXPECT_EQ(made.mesh.stats.exact_parts, 1u);
  EXPECT_EQ(made.input().rebuilt_parts, 1u);
}

TEST(UniteThin, GroupsAreBuiltEachByItself) {
  const Mesh one = shapes::merged({thin_bar(0, 0, 0), thin_bar(1, 0, 0)});
  const Mesh two = shapes::translated(one, Vec3(0, 0, 1));
  const Mesh alone = shapes::translated(thin_bar(0, 0, 0), Vec3(0, 0, 2));
  const MadeOfBars made = make_bars(shapes::merged({one, two, alone}));
  EXPECT_EQ(made.result.components, 3);
  EXPECT_EQ(made.result.euler_characteristic, 6);
  EXPECT_EQ(made.input().rebuilt_parts, 4u);
  EXPECT_EQ(made.mesh.stats.exact_parts, 3u);
}

TEST(UniteThin, FacesKeepTheirSources) {
  const Mesh mesh = grating(2, 0);
  const ExtractedMesh out = extract(build_grid(mesh, {.tolerance = kCoarse}));
  ASSERT_EQ(out.source_faces.size(), out.triangles.size());
  std::vector<char> found(mesh.triangles.size() / 2, 0);  // per side of a bar
  for (std::size_t t = 0; t < out.triangles.size(); ++t) {
    ASSERT_LT(out.source_faces[t], mesh.triangles.size());
    found[out.source_faces[t] / 2] = 1;
  }
  EXPECT_EQ(std::count(found.begin(), found.end(), 1), static_cast<int>(found.size()));
}

// What is not united is no worse than before: it goes through cells and is told.
void expect_told(const Mesh& mesh, const BuildOptions& options, Index thin_parts) {
  const Grid grid = build_grid(mesh, options);
  EXPECT_EQ(grid.input().rebuilt_parts, 0u);
  EXPECT_EQ(grid.stats().thin_parts, thin_parts);
}

TEST(UniteThin, WhatIsNearAThickPartStays) {
  const Mesh post = shapes::box(Vec3(-0.6, -0.6, -1), Vec3(0.6, 0.6, -1.5 * kCoarse));
  expect_told(shapes::merged({grating(2, 0), post}), {.tolerance = kCoarse}, 4);
}

TEST(UniteThin, WhatFormsAThickPartStays) {
  // Plates that lie on each other.
  std::vector<Mesh> plates;
  for (int i = 0; i < 8; ++i) {
    plates.push_back(shapes::box(Vec3(-1, -1, i * kCoarse), Vec3(1, 1, (i + 1) * kCoarse)));
    plates.back().positions[7] += Vec3(1e-3 * i, 0, 0);  // they share no faces
  }
  EXPECT_EQ(build_grid(shapes::merged(plates), {.tolerance = kCoarse}).input().rebuilt_parts, 0u);
}

TEST(UniteThin, OnlyWhereWhatIsInSomePartIsInside) {
  const Mesh crossing = grating(2, 0);
  expect_told(crossing, {.tolerance = kCoarse, .inside = InsideRule::kOdd}, 4);
  // Where both bars and the part that is inside out are, one of the bars is taken away.
  const Mesh inside_out = shapes::inverted(shapes::box(Vec3::Constant(-2), Vec3::Constant(2)));
  EXPECT_EQ(build_grid(shapes::merged({crossing, inside_out}),
                       {.tolerance = kCoarse, .inside = InsideRule::kPositive})
                .input()
                .rebuilt_parts,
            0u);
}

TEST(UniteThin, LongWiresStayOnceTheCellsAreSpent) {
  constexpr double kThin = 1e-5;
  const Mesh long_bars =
      shapes::merged({shapes::box(Vec3(-1, -kThin, -kThin), Vec3(1, kThin, kThin)),
                      shapes::box(Vec3(-kThin, -1, -kThin), Vec3(kThin, 1, kThin))});
  expect_told(long_bars, {.tolerance = kCoarse}, 2);
  // A short pair is not held back by it.
  const Mesh both = shapes::merged(
      {long_bars,
       shapes::translated(shapes::merged({thin_bar(0, 0, 0), thin_bar(1, 0, 0)}), Vec3(0, 0, 1))});
  const Grid grid = build_grid(both, {.tolerance = kCoarse});
  EXPECT_EQ(grid.input().rebuilt_parts, 2u);
  EXPECT_EQ(grid.stats().thin_parts, 2u);
}

}  // namespace
}  // namespace kdm
