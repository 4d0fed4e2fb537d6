// SPDX-License-Identifier: MIT
// What construction hands to the steps after it.
#include "construct/construct.h"

#include <gtest/gtest.h>

#include <cmath>

#include "construct/budget.h"
#include "inside/make_inside_model.h"
#include "kdmanifold/extract.h"
#include "support/shapes.h"

namespace kdm {
namespace {

// The plane of a hit is that of its triangle, turned out of the solid, and names the same face.
TEST(Construct, HitsKnowTheirTriangles) {
  const std::vector<std::pair<Mesh, InsideRule>> cases = {
      {shapes::nested_spheres(), InsideRule::kOdd},
      {shapes::nested_shells(), InsideRule::kPositive},
      {shapes::open(shapes::icosphere(3), 40), InsideRule::kRepair},
      {shapes::open(shapes::torus(), 40), InsideRule::kSheet}};
  for (const auto& [mesh, rule] : cases) {
    const BuildOptions options{
        .strategy = SplitStrategy::kUniform, .inside = rule, .winding_threshold = 0.5};
    const Surface surface = prepare_surface(mesh, options);
    const std::size_t planes_before = surface.planes.size();
    GridData grid;
    const ConstructedCells made = construct_cells(
        surface, *make_inside_model(surface, options, 1000), options, 1000, 12, {}, {}, grid);
    EXPECT_EQ(made.tolerance, 1000);
    EXPECT_EQ(surface.planes.size(), planes_before);
    ASSERT_EQ(made.triangle_of_hit.size(), grid.hits.size());
    ASSERT_GT(grid.hits.size(), 100u);
    std::size_t invented = 0;
    for (HitId h = 0; h < grid.hits.size(); ++h) {
      const TriangleId triangle = made.triangle_of_hit[h];
      const PlaneId plane = grid.hits[h].plane();
      ASSERT_LT(plane, grid.planes.size());
      EXPECT_EQ(grid.invented(h), triangle == kNone);
      if (triangle == kNone) {
        ++invented;
        continue;
      }
      EXPECT_EQ(grid.source_faces[plane], surface.source_faces[triangle]);
      const double cosine = grid.planes[plane].normal.dot(surface.planes[triangle].normal);
      EXPECT_NEAR(std::abs(cosine), 1, 1e-12);
    }
    EXPECT_EQ(invented > 0, surface.repair);
    EXPECT_EQ(grid.planes.capacity(), grid.planes.size());
    EXPECT_EQ(grid.hits.capacity(), grid.hits.size());
  }
}

TEST(Budget, WithoutLimitsIsNeverExceeded) {
  Budget budget;
  for (int i = 0; i < 1000; ++i) budget.take_split();
  EXPECT_FALSE(budget.exceeded(~std::size_t{0} - 1, 0.5));
  EXPECT_TRUE(budget.sufficed());
  EXPECT_EQ(budget.done(), 1);
}

TEST(Budget, StaysExceededFromTheFirstLimitOn) {
  Budget budget = Budget::for_repair(10, 1000);
  EXPECT_FALSE(budget.exceeded(1000, 0.1));
  EXPECT_TRUE(budget.exceeded(1u << 30, 0.4)) << "by work";
  EXPECT_TRUE(budget.exceeded(0, 0.7));
  EXPECT_FALSE(budget.sufficed());
  EXPECT_EQ(budget.done(), 0.4);

  Budget splits = Budget::for_repair(0, 0);
  int taken = 0;
  while (!splits.exceeded(0, 0.2)) {
    splits.take_split();
    ASSERT_LT(++taken, 1000000);
  }
  EXPECT_EQ(taken, 300000);
}

// A vertex for each cell of 10 x 5 x 3 that is not amid the others.
TEST(Construct, CellsAreCountedAlongTheLongestSide) {
  const Mesh block = shapes::box(Vec3(1, 2, 3), Vec3(21, 12, 9));
  const Grid grid = build_grid(block, {.strategy = SplitStrategy::kUniform, .cells = 10});
  EXPECT_EQ(extract(grid, {.strict = Strict::kOff}).positions.size(), 10u * 5 * 3 - 8 * 3 * 1);
}

// No tolerance counts, so that cells are small wherever the surface is bent; flat ones stay large.
TEST(Construct, CellsOfAnOctreeAreAsSmallWhereTheSurfaceIsBent) {
  const BuildOptions uniform{.strategy = SplitStrategy::kUniform, .cells = 12};
  const BuildOptions octree{.strategy = SplitStrategy::kOctree, .cells = 12};
  const auto vertices = [](const Mesh& mesh, const BuildOptions& options) {
    return extract(build_grid(mesh, options), {.strict = Strict::kOff}).positions.size();
  };
  const Mesh ball = shapes::icosphere(4);
  EXPECT_EQ(build_grid(ball, octree).stats().depth, 12);
  EXPECT_TRUE(build_grid(ball, octree).stats().topology_resolved);
  EXPECT_GT(vertices(ball, octree), vertices(ball, uniform) * 9 / 10);
  EXPECT_LT(vertices(shapes::cube(), octree), vertices(shapes::cube(), uniform) / 4);
}

}  // namespace
}  // namespace kdm
