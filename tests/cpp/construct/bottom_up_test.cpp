// SPDX-License-Identifier: MIT
// Grids that are made from their finest cells upwards are those that a recursion from the root
// makes, to the last byte.
#include "construct/bottom_up.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "construct/grid_of_surface.h"
#include "grid/validate.h"
#include "inside/make_inside_model.h"
#include "kdmanifold/error.h"
#include "support/grid_compare.h"
#include "support/random.h"
#include "support/random_meshes.h"
#include "support/shapes.h"

namespace kdm {
namespace {

constexpr int kDeepest = FinestCells::kMostDepth;

struct BothWays {
  Grid upwards;
  Grid downwards;
};

// The recursion is taken where cells are noted for the next construction; notes name solids.
BothWays build_both_ways(const Mesh& mesh, const BuildOptions& options) {
  Surface surface = prepare_surface(mesh, options);
  surface.solid_of.assign(surface.triangles.size(), 0);
  const double tolerance = lattice_tolerance(surface, options);
  const auto build = [&](const CellMemory& memory) {
    const auto model = make_inside_model(surface, options, tolerance);
    const int depth = options.cells > 0 ? 3 * halvings_for(options.cells) : options.depth;
    EXPECT_TRUE(suits_bottom_up(surface, *model, options, depth));
    return Grid(grid_of_surface(surface, *model, options, tolerance, {}, {}, memory));
  };
  FormerCells notes;
  return {build({}), build({.notes = &notes})};
}

void expect_same_both_ways(const Mesh& mesh, const BuildOptions& options) {
  const BothWays grids = build_both_ways(mesh, options);
  check::expect_same(grids.upwards, grids.downwards);
  EXPECT_EQ(grids.upwards.data().bytes(), grids.downwards.data().bytes());
  EXPECT_NO_THROW(validate(grids.upwards.data()));
}

BuildOptions uniform(int depth, InsideRule rule = InsideRule::kPositive) {
  return {.strategy = SplitStrategy::kUniform, .depth = depth, .inside = rule};
}

TEST(BottomUp, EveryShapeIsTheSame) {
  for (const shapes::NamedShape& shape : shapes::all_shapes()) {
    SCOPED_TRACE(shape.name);
    for (const int depth : {1, 2, 7, 12, 16}) {
      SCOPED_TRACE(depth);
      expect_same_both_ways(shape.mesh, uniform(depth));
      expect_same_both_ways(shapes::turned(shape.mesh), uniform(depth));
    }
  }
}

TEST(BottomUp, EveryRuleIsTheSame) {
  for (const InsideRule rule :
       {InsideRule::kPositive, InsideRule::kOdd, InsideRule::kNonzero, InsideRule::kSheet}) {
    SCOPED_TRACE(static_cast<int>(rule));
    for (std::uint32_t seed = 0; seed < 8; ++seed) {
      SCOPED_TRACE(seed);
      const int depth = 5 + static_cast<int>(seed);
      expect_same_both_ways(shapes::integer_tetrahedra(12, 5, seed), uniform(depth + 4, rule));
      expect_same_both_ways(shapes::collapsed_polyhedron(4, seed), uniform(depth, rule));
    }
  }
}

// Faces in grid planes, edges in grid lines, vertices on grid vertices.
TEST(BottomUp, TiesAreResolvedTheSameWay) {
  for (std::uint32_t seed = 0; seed < 10; ++seed) {
    SCOPED_TRACE(seed);
    const int depth = 6 + static_cast<int>(seed);
    expect_same_both_ways(shapes::random_voxels(4, 0.4, seed), uniform(depth));
    BuildOptions cells = uniform(0);
    cells.cells = 8;
    expect_same_both_ways(shapes::random_voxels(8, 0.3, seed), cells);
  }
}

// Many small solids, thin ones, some turned inside out, some far larger than the others.
TEST(BottomUp, RandomSolidsAreTheSame) {
  for (std::uint32_t seed = 0; seed < 40; ++seed) {
    SCOPED_TRACE(seed);
    check::Random random(seed);
    std::vector<Mesh> parts;
    for (std::uint32_t i = 0; i < 1 + random.below(12); ++i) {
      Mesh part = random.coin() ? shapes::icosphere(1) : shapes::cube();
      if (random.below(4) == 0) part = shapes::inverted(part);
      const double size = random.below(5) == 0 ? 1 : 0.1;
      part = shapes::scaled(part, Vec3(size, size * random.between(0.01, 1), size));
      part = shapes::rotated(part, random.direction(), random.between(0, 3));
      parts.push_back(shapes::translated(part, random.point(-1, 1)));
    }
    const int depth = 1 + static_cast<int>(random.below(17));
    const InsideRule rule = random.coin() ? InsideRule::kPositive : InsideRule::kRepair;
    expect_same_both_ways(shapes::merged(parts), uniform(depth, rule));
    expect_same_both_ways(shapes::random_tetrahedra(20, seed), uniform(depth, rule));
  }
}

TEST(BottomUp, ThinSolidsAreTheSameWhereGapsAreClosed) {
  for (std::uint32_t seed = 0; seed < 10; ++seed) {
    SCOPED_TRACE(seed);
    check::Random random(seed);
    std::vector<Mesh> slabs;
    for (int i = 0; i < 6; ++i) {
      // Some gaps between the slabs are closed, others stay open or hold a grid vertex.
      const double gap = random.below(3) * 1e-6;
      slabs.push_back(shapes::box(Vec3(0, 0, i + gap), Vec3(1 + i, 1, i + 1)));
    }
    const Mesh mesh = shapes::rotated(shapes::merged(slabs), random.direction(),
                                      random.coin() ? 0 : random.between(0, 1e-5));
    for (const int depth : {10, 12, 14}) expect_same_both_ways(mesh, uniform(depth));
  }
}

TEST(BottomUp, DeepGridsAreTheSame) {
  expect_same_both_ways(shapes::turned(shapes::scaled(shapes::cube(), Vec3(1, 0.01, 0.02))),
                        uniform(kDeepest));
}

TEST(BottomUp, IsLeftToTheRecursionWhereItDoesNotFit) {
  const auto suits = [](const Mesh& mesh, const BuildOptions& options, int depth) {
    const Surface surface = prepare_surface(mesh, options);
    return suits_bottom_up(surface, *make_inside_model(surface, options, 100), options, depth);
  };
  const BuildOptions repair = uniform(12, InsideRule::kRepair);
  EXPECT_TRUE(suits(shapes::cube(), repair, kDeepest));
  EXPECT_FALSE(suits(shapes::cube(), repair, kDeepest + 1)) << "deeper";
  BuildOptions adaptive = repair;
  adaptive.strategy = SplitStrategy::kAdaptive;
  EXPECT_FALSE(suits(shapes::cube(), adaptive, 12)) << "another rule";
  EXPECT_FALSE(suits(shapes::open(shapes::icosphere(2), 2), repair, 12)) << "holes";
}

TEST(BottomUp, StopsWhenAsked) {
  constexpr int kDepth = 18;
  const Mesh mesh = shapes::icosphere(5);
  const Surface surface = prepare_surface(mesh, uniform(kDepth));
  std::vector<double> fractions;
  for (int calls = 1;; ++calls) {
    const auto model = make_inside_model(surface, uniform(kDepth), 100);
    GridData grid;
    std::vector<TriangleId> triangle_of_hit;
    int left = calls;
    fractions.clear();
    const Progress progress = [&](double fraction, std::string_view) {
      fractions.push_back(fraction);
      return --left > 0;
    };
    try {
      construct_bottom_up(surface, *model, kDepth, progress, grid, triangle_of_hit);
      EXPECT_GT(left, 0);
      break;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::kAborted);
      EXPECT_EQ(left, 0);
    }
  }
  EXPECT_GT(fractions.size(), 3u);
  EXPECT_TRUE(std::is_sorted(fractions.begin(), fractions.end()));
  EXPECT_LE(fractions.back(), 1);
}

}  // namespace
}  // namespace kdm
