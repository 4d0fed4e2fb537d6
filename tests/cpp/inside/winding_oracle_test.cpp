// SPDX-License-Identifier: MIT
// Open, flipped, doubled and torn surfaces become the solids they mean.
#include <gtest/gtest.h>

#include <string>

#include "grid/grid_data.h"
#include "grid/validate.h"
#include "kdmanifold/build.h"
#include "kdmanifold/error.h"
#include "kdmanifold/extract.h"
#include "kdmanifold/grid_io.h"
#include "support/mesh_check.h"
#include "support/random.h"
#include "support/sanitized.h"
#include "support/shapes.h"

namespace kdm {
namespace {

using check::Random;

struct Damage {
  std::string name;
  Mesh mesh;
};

// Whole patches of a mesh out: all faces within a distance of points on it.
Mesh punched(Mesh mesh, int holes, double radius) {
  Random random(17);
  std::vector<Vec3> centres;
  for (int i = 0; i < holes; ++i) {
    centres.push_back(mesh.positions[random.below(static_cast<Index>(mesh.positions.size()))]);
  }
  std::erase_if(mesh.triangles, [&](const Triangle& t) {
    return std::any_of(centres.begin(), centres.end(), [&](const Vec3& centre) {
      return (mesh.positions[t[0]] - centre).norm() < radius;
    });
  });
  return mesh;
}

Mesh flipped(Mesh mesh, std::uint32_t percent) {
  Random random(percent);
  for (Triangle& t : mesh.triangles) {
    if (random.below(100) < percent) std::swap(t[1], t[2]);
  }
  return mesh;
}

Mesh doubled(Mesh mesh, std::uint32_t percent) {
  Random random(percent);
  const std::size_t faces = mesh.triangles.size();
  for (std::size_t i = 0; i < faces; ++i) {
    if (random.below(100) < percent) mesh.triangles.push_back(mesh.triangles[i]);
  }
  return mesh;
}

// Large ones, all through each other.
Mesh random_triangles(Index count) {
  Random random(1);
  Mesh mesh;
  for (Index i = 0; i < count; ++i) {
    for (int k = 0; k < 3; ++k) mesh.positions.push_back(random.point(0, 1));
    mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  return mesh;
}

Mesh extract_sound(const Grid& grid, const std::string& name) {
  EXPECT_NO_THROW(validate(grid.data())) << name;
  Mesh out = extract(grid);
  const check::MeshCheck report = check::check_mesh(out);
  EXPECT_TRUE(report.two_manifold) << name;
  return out;
}

std::vector<BuildOptions> all_strategies() {
  return {{.relative_tolerance = 0.01},
          {.strategy = SplitStrategy::kOctree, .relative_tolerance = 0.01},
          {.strategy = SplitStrategy::kFeature, .relative_tolerance = 0.01},
          {.strategy = SplitStrategy::kMedian, .depth = 15},
          {.strategy = SplitStrategy::kUniform, .depth = 12}};
}

// However cells are split, whatever the input: closed and 2-manifold, and the grid is sound.
TEST(WindingOracle, EverythingBecomesASolid) {
  const std::vector<Damage> cases = {
      {"sphere with a hole", shapes::open(shapes::icosphere(3), 60)},
      {"sphere with many holes", punched(shapes::icosphere(3), 8, 0.2)},
      {"torus with turned faces", flipped(shapes::open(shapes::torus(), 4), 30)},
      {"torn sphere", shapes::jittered(shapes::soup(shapes::icosphere(3)), 0.02, 3)},
      {"box without a side", shapes::open(shapes::cube(), 2)},
      {"half a sphere", shapes::open(shapes::icosphere(3), 640)},
      {"two open boxes",
       shapes::merged({shapes::open(shapes::cube(), 2),
                       shapes::translated(shapes::open(shapes::cube(), 2), Vec3(0.5, 0.4, 0.3))})},
      {"random triangles", random_triangles(60)}};
  for (const Damage& damage : cases) {
    for (const BuildOptions& options : all_strategies()) {
      for (const double threshold : {0.0, 0.4}) {  // with and without patches
        const std::string name = damage.name + ", strategy " +
                                 std::to_string(static_cast<int>(options.strategy)) +
                                 ", threshold " + std::to_string(threshold);
        // The random triangles meet themselves everywhere, which takes a minute with sanitizers.
        if (check::kSanitized && damage.name == "random triangles" && threshold == 0) continue;
        if (check::kSanitized && options.strategy == SplitStrategy::kFeature) continue;
        BuildOptions asked = options;
        asked.winding_threshold = threshold;
        const Mesh out = extract_sound(build_grid(damage.mesh, asked), name);
        EXPECT_GT(shapes::signed_volume(out), 0) << name;
      }
    }
  }
}

// No tolerance is met where triangles cross everywhere: the whole is met as closely as time allows.
TEST(WindingOracle, WhatWouldTakeForEverIsMetLessClosely) {
  if (check::kSanitized) GTEST_SKIP() << "takes a minute with sanitizers";
  const BuildOptions options{.tolerance = 0.001};
  EXPECT_EQ(build_grid(random_triangles(30), {.tolerance = 0.05}).stats().tolerance, 0.05);
  double shown = 0;
  const Grid grid =
      build_grid(random_triangles(300), options, [&](double fraction, std::string_view) {
        EXPECT_GE(fraction, shown);
        shown = fraction;
        return true;
      });
  EXPECT_GT(grid.stats().tolerance, 2 * options.tolerance);
  EXPECT_EQ(shown, 1);
  extract_sound(grid, "random triangles");
}

TEST(WindingOracle, ClosedInputIsTakenAsItIs) {
  for (const Mesh& mesh : {shapes::cube(), shapes::nested_spheres(), shapes::overlapping_cubes(),
                           shapes::cube_with_flaps(), shapes::inverted(shapes::torus())}) {
    const Grid exact = build_grid(mesh, {.inside = InsideRule::kPositive});
    const Grid repaired = build_grid(mesh);
    EXPECT_EQ(save_grid(exact), save_grid(repaired));
    EXPECT_EQ(repaired.stats().invented_hits, 0u);
  }
}

TEST(WindingOracle, ABoxWithoutASideIsABox) {
  const Grid grid = build_grid(shapes::open(shapes::cube(), 2),
                               {.relative_tolerance = 0.01, .winding_threshold = 0.5});
  const ExtractedMesh out = extract(grid);
  EXPECT_TRUE(check::check_mesh(out).two_manifold);
  EXPECT_GT(grid.stats().invented_hits, 0u);
  EXPECT_FALSE(grid.stats().topology_resolved);
  EXPECT_FALSE(grid.input().closed);
  // The field bulges out of the opening or in by less than a twentieth of the box.
  EXPECT_NEAR(shapes::signed_volume(out), 1, 0.05);
  EXPECT_NEAR(out.report.invented_area, 1, 0.2);
  double invented = 0;
  for (std::size_t i = 0; i < out.triangles.size(); ++i) {
    if (out.source_faces[i] == kNone) ++invented;
  }
  EXPECT_GT(invented, 0);
}

// What flips and doubles break is mended before anything is asked of winding numbers.
TEST(WindingOracle, TurnedAndDoubledFacesLeaveNoTrace) {
  const BuildOptions options{.relative_tolerance = 0.005};
  const Mesh intact = shapes::torus();
  const Mesh expected = extract(build_grid(intact, options));
  for (const std::uint32_t percent : {1u, 10u, 30u}) {
    const Grid grid = build_grid(flipped(intact, percent), options);
    EXPECT_GT(grid.input().turned_faces, 0u);
    EXPECT_EQ(grid.stats().invented_hits, 0u);
    EXPECT_EQ(extract(grid).positions, expected.positions) << percent;
  }
  const Grid grid = build_grid(doubled(intact, 10), options);
  EXPECT_GT(grid.input().duplicate_faces, 0u);
  EXPECT_EQ(extract(grid).positions, expected.positions);
}

TEST(WindingOracle, HolesKeepTheRest) {
  const Mesh intact = shapes::icosphere(5);
  const double whole = shapes::signed_volume(intact);
  for (const int holes : {1, 5, 20}) {
    const Mesh damaged = punched(intact, holes, 0.1);
    const Mesh out = extract_sound(build_grid(damaged, {.relative_tolerance = 0.003}),
                                   std::to_string(holes) + " holes");
    EXPECT_EQ(describe(out).components, 1u);
    EXPECT_EQ(describe(out).euler_characteristic, 2);
    EXPECT_NEAR(shapes::signed_volume(out), whole, 0.01 * whole) << holes;
    for (const Vec3& p : out.positions) EXPECT_NEAR(p.norm(), 1, 0.04);
  }
}

// Cracks narrower than the tolerance are sewn, and nothing is left to repair.
TEST(WindingOracle, CracksLeaveNoTrace) {
  const Mesh intact = shapes::torus();
  const Mesh torn = shapes::jittered(shapes::soup(intact), 0.001, 9);
  const Grid grid = build_grid(torn, {.relative_tolerance = 0.002});
  EXPECT_EQ(grid.input().sewn_edges, 3 * intact.triangles.size() / 2);
  EXPECT_EQ(grid.input().boundary_loops, 0u);
  EXPECT_EQ(grid.stats().invented_hits, 0u);
  EXPECT_TRUE(grid.stats().topology_resolved);
  const Mesh out = extract_sound(grid, "cracked");
  EXPECT_EQ(describe(out).components, 1u);
  EXPECT_EQ(describe(out).euler_characteristic, 0);
  EXPECT_NEAR(shapes::signed_volume(out), shapes::signed_volume(intact), 0.01);
}

// Wider ones, beyond what torn surfaces are sewn at, are not: the winding number closes the gaps.
TEST(WindingOracle, ATornSphereIsASphere) {
  const Mesh intact = shapes::icosphere(3);
  const Mesh torn = shapes::jittered(shapes::soup(intact), 0.02, 9);
  const Grid grid = build_grid(torn, {.tolerance = check::kSanitized ? 0.001 : 0.0005});
  EXPECT_EQ(grid.input().sewing_distance, 0);
  EXPECT_GT(grid.stats().invented_hits, 0u);
  const Mesh out = extract_sound(grid, "torn");
  EXPECT_NEAR(shapes::signed_volume(out), shapes::signed_volume(intact), 0.1);
  for (const Vec3& p : out.positions) EXPECT_NEAR(p.norm(), 1, 0.1);
}

TEST(WindingOracle, TheRimIsMet) {
  // The opening's corners are corners of the result.
  const Mesh mesh = shapes::open(shapes::cube(), 2);
  const Mesh out = extract(build_grid(mesh, {.relative_tolerance = 0.01}));
  for (const Vec3& corner : shapes::cube().positions) {
    double nearest = 1;
    for (const Vec3& p : out.positions) nearest = std::min(nearest, (p - corner).norm());
    EXPECT_LT(nearest, 0.02) << corner.transpose();
  }
}

TEST(WindingOracle, WhatEnclosesNothingIsSaidTo) {
  Mesh sheet;
  sheet.positions = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)};
  sheet.triangles = {{0, 1, 2}};
  try {
    build_grid(sheet);
    FAIL() << "accepted";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kNotClosed);
    EXPECT_NE(std::string(error.what()).find("encloses nothing"), std::string::npos);
  }
}

// Slivers along a line are hit by grid edges here and there.
TEST(WindingOracle, WhatComesToNothingIsRefused) {
  // With and without patches. Of most such slivers a crumb is left for one of the two.
  for (const auto& [threshold, seed] : {std::pair(0.0, 4u), std::pair(0.5, 8u)}) {
    Random random(seed);
    Mesh mesh;
    for (Index i = 0; i < 100; ++i) {
      for (int k = 0; k < 3; ++k) {
        const double x = random.unit();
        mesh.positions.emplace_back(x, 2 * x, 3 * x);
      }
      mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
    }
    try {
      extract(build_grid(mesh, {.winding_threshold = threshold}));
      FAIL();
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::kNotClosed);
    }
  }
}

TEST(WindingOracle, TheThresholdIsAnOption) {
  const Mesh half = shapes::open(shapes::icosphere(3), 640);
  double last = 0;
  for (const double threshold : {0.8, 0.5, 0.2}) {
    const Mesh out =
        extract(build_grid(half, {.relative_tolerance = 0.01, .winding_threshold = threshold}));
    EXPECT_GT(shapes::signed_volume(out), last) << threshold;
    last = shapes::signed_volume(out);
  }
  for (const double threshold : {1.0, -1.0, 2.0}) {
    EXPECT_THROW(build_grid(half, {.winding_threshold = threshold}), Error) << threshold;
  }
}

// A tub whose outside ends half way down: below its floor less than half of the surroundings is
// seen from behind.
Mesh tub() {
  Mesh mesh = shapes::revolved(
      {{0, -0.2}, {1, -0.2}, {1, 0.2}, {1, 0.6}, {1, 1}, {0.9, 1}, {0.9, 0}, {0, 0}}, 64);
  std::erase_if(mesh.triangles, [&](const Triangle& t) {
    return std::any_of(t.begin(), t.end(), [&](Index v) { return mesh.positions[v].z() < -0.1; });
  });
  return mesh;
}

TEST(WindingOracle, TheThresholdKeepsWhatItCan) {
  const auto is_near_floor = [](const Mesh& mesh) {
    return std::any_of(mesh.positions.begin(), mesh.positions.end(), [](const Vec3& p) {
      return std::abs(p.z()) < 0.02 && std::hypot(p.x(), p.y()) < 0.5;
    });
  };
  const Grid kept = build_grid(tub(), {.relative_tolerance = 0.005});
  EXPECT_LT(kept.stats().winding_threshold, 0.5);
  EXPECT_TRUE(is_near_floor(extract(kept)));
  const Grid lost = build_grid(tub(), {.relative_tolerance = 0.005, .winding_threshold = 0.4});
  EXPECT_EQ(lost.stats().winding_threshold, 0.4);
  EXPECT_FALSE(is_near_floor(extract(lost)));
  EXPECT_THROW(build_grid(tub(), {.winding_threshold = 0.5}), Error);
  // Saved with the grid; and none is asked for where all is closed.
  EXPECT_EQ(load_grid(save_grid(kept)).stats().winding_threshold, kept.stats().winding_threshold);
  EXPECT_EQ(build_grid(shapes::cube()).stats().winding_threshold, 0);
}

TEST(WindingOracle, HolesTooWideToBeClosedAreRefused) {
  // The unit square's diagonal.
  const Mesh box = shapes::open(shapes::cube(), 2);
  EXPECT_GT(build_grid(box, {.tolerance = 0.01, .largest_hole = 1.42}).stats().hits, 0u);
  try {
    build_grid(box, {.tolerance = 0.01, .largest_hole = 1.41});
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kNotClosed);
    EXPECT_NE(std::string(error.what()).find("1 of 1 holes are wider than `largest_hole`"),
              std::string::npos);
  }
  // Closed surfaces and sheets have none to close.
  EXPECT_GT(build_grid(shapes::cube(), {.largest_hole = 0.1}).stats().hits, 0u);
  EXPECT_THROW(build_grid(box, {.inside = InsideRule::kSheet, .largest_hole = 0.1}), Error);
  EXPECT_THROW(build_grid(box, {.largest_hole = -1}), Error);
}

TEST(WindingOracle, GridsAreSavedWithWhatWasInvented) {
  const Grid grid = build_grid(punched(shapes::icosphere(3), 3, 0.3),
                               {.relative_tolerance = 0.01, .winding_threshold = 0.5});
  const std::vector<std::uint8_t> bytes = save_grid(grid);
  const Grid loaded = load_grid(bytes);
  EXPECT_EQ(save_grid(loaded), bytes);
  EXPECT_EQ(loaded.stats().invented_hits, grid.stats().invented_hits);
  EXPECT_GT(loaded.data().rims.size(), 0u);
  EXPECT_EQ(extract(loaded).positions, extract(grid).positions);
}

}  // namespace
}  // namespace kdm
