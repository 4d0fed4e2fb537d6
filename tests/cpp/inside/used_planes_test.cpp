// SPDX-License-Identifier: MIT
// Which planes a built grid keeps.
#include <gtest/gtest.h>

#include <cmath>

#include "grid/grid_data.h"
#include "kdmanifold/build.h"
#include "kdmanifold/extract.h"
#include "support/shapes.h"

namespace kdm {
namespace {

// 20,480 faces, most of which no grid edge meets.
TEST(UsedPlanes, FacesWithoutHitsLeaveNothing) {
  const Grid grid =
      build_grid(shapes::icosphere(5), {.strategy = SplitStrategy::kUniform, .depth = 12});
  const GridData& data = grid.data();
  EXPECT_LT(data.planes.size(), 5000u);
  EXPECT_LE(data.planes.size(), data.hits.size());
  EXPECT_EQ(grid.stats().bytes, data.bytes());
  EXPECT_LE(grid.stats().bytes, 150 * extract(grid).triangles.size());
}

TEST(UsedPlanes, MemoryIsWhatWasAllocated) {
  GridData grid;
  const std::size_t empty = grid.bytes();
  grid.planes.reserve(100);
  grid.hits.reserve(10);
  EXPECT_EQ(grid.bytes(), empty + 100 * sizeof(Plane) + 10 * sizeof(Hit));
}

double up_edge(const GridData& grid, const Cell& cell, Index i, Index hit) {
  return grid.planes[grid.hits[hit].plane()].normal[axis_of_edge(cell.axis(), static_cast<int>(i))];
}

// A ball in a ball: with odd windings a cavity, whichever way the inner one faces; and a ball that
// is inside out, a solid if what is not zero is inside.
TEST(UsedPlanes, PointOutOfTheSolid) {
  const Mesh ball_and_turned =
      shapes::merged({shapes::icosphere(3),
                      shapes::translated(shapes::inverted(shapes::icosphere(2)), Vec3(3, 0, 0))});
  const std::vector<std::pair<Mesh, InsideRule>> cases = {
      {shapes::nested_shells(), InsideRule::kOdd},
      {shapes::nested_spheres(), InsideRule::kOdd},
      {shapes::nested_spheres(), InsideRule::kPositive},
      {ball_and_turned, InsideRule::kNonzero}};
  for (const auto& [mesh, rule] : cases) {
    const GridData grid =
        build_grid(mesh, {.strategy = SplitStrategy::kUniform, .depth = 12, .inside = rule}).data();
    for (const Cell& cell : grid.cells) {
      if (cell.leaf()) continue;
      for (Index i = 0; i < 4; ++i) {
        for (const HitId h : grid.edge_hits(4 * cell.split() + i)) {
          const double up = up_edge(grid, cell, i, h);
          if (std::abs(up) < 1e-3) continue;  // the lattice's triangle is another
          ASSERT_EQ(up > 0, grid.hits[h].leaving());
        }
      }
    }
  }
}

// Every plane is that of the face which it names, but for the lattice's units.
TEST(UsedPlanes, KeepTheirFaces) {
  const Mesh mesh = shapes::rotated(shapes::torus(1, 0.4, 24, 12), Vec3(1, 2, 3), 1);
  const GridData grid = build_grid(mesh, {.strategy = SplitStrategy::kUniform, .depth = 9}).data();
  ASSERT_GT(grid.planes.size(), 100u);
  for (std::size_t p = 0; p < grid.planes.size(); ++p) {
    for (const Index v : mesh.triangles[grid.source_faces[p]]) {
      const Vec3 corner = grid.lattice.to_lattice(mesh.positions[v]);
      ASSERT_NEAR(grid.planes[p].normal.dot(corner), grid.planes[p].offset, 1e-6) << p;
    }
  }
}

}  // namespace
}  // namespace kdm
