// SPDX-License-Identifier: MIT
// Corners of the surface come out where they are, also where their leaf's edges miss a plane.
#include "link/corners.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "grid/validate.h"
#include "kdmanifold/build.h"
#include "kdmanifold/extract.h"
#include "kdmanifold/mesh.h"
#include "support/mesh_assert.h"
#include "support/random.h"
#include "support/shapes.h"

namespace kdm {
namespace {

using check::Random;

constexpr double kGap = 0.05;  // of a cell
constexpr int kRotations = 40;

Mesh turned(const Mesh& mesh, Random& random) {
  const Vec3 axis = random.direction();
  return shapes::rotated(mesh, axis, random.between(0.1, 3));
}

// Of a grid with so many cells an axis.
double cell_size(const Grid& grid, int cells) {
  return grid.input().lattice_step * kLatticeSize / cells;
}

// The largest distance of one of the points to the nearest of the others.
double gap(const std::vector<Vec3>& points, const std::vector<Vec3>& others) {
  double largest = 0;
  for (const Vec3& p : points) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const Vec3& q : others) nearest = std::min(nearest, (p - q).norm());
    largest = std::max(largest, nearest);
  }
  return largest;
}

Index leaf_of(const GridData& grid, const Vec3& point) {
  Index c = 0;
  while (!grid.cells[c].leaf()) {
    const Cell& cell = grid.cells[c];
    c = point[cell.axis()] <= cell.value() ? cell.below() : cell.above();
  }
  return c;
}

// Do the planes of hits round the leaf tell of all three planes of a cube's corner?
bool shown(const GridData& grid, Index leaf) {
  std::vector<Vec3> normals;
  for (Index h = 0; h < grid.start.size(); ++h) {
    if (grid.start_leaf(h) != leaf) continue;
    const Vec3& normal = grid.plane_of(h / 3).normal;
    if (std::none_of(normals.begin(), normals.end(),
                     [&](const Vec3& n) { return n.dot(normal) > 0.5; })) {
      normals.push_back(normal);
    }
  }
  return normals.size() == 3;
}

TEST(Corners, OfTurnedCubesAreMet) {
  const BuildOptions octree{
      .strategy = SplitStrategy::kOctree, .relative_tolerance = 0, .depth = 18};
  const BuildOptions uniform{.strategy = SplitStrategy::kUniform, .depth = 12};
  const BuildOptions adaptive{.relative_tolerance = 0.002};
  for (const auto& [options, cells] : {std::pair(octree, 64), {uniform, 16}, {adaptive, 64}}) {
    SCOPED_TRACE(static_cast<int>(options.strategy));
    Random random(1);
    int missed = 0;
    for (int i = 0; i < kRotations; ++i) {
      SCOPED_TRACE(i);
      const Mesh cube = turned(shapes::cube(), random);
      const Grid grid = build_grid(cube, options);
      const Mesh out = extract(grid, {.strict = Strict::kManifold});
      EXPECT_LE(gap(cube.positions, out.positions), kGap * cell_size(grid, cells));
      EXPECT_TRUE(check::is_two_manifold(out));
      for (const Vec3& p : cube.positions) {
        const Index leaf = leaf_of(grid.data(), grid.data().lattice.to_lattice(p));
        missed += shown(grid.data(), leaf) ? 0 : 1;
      }
    }
    EXPECT_GT(missed, 0) << "otherwise nothing is tested";
  }
}

// A wedge that is cut off at an angle: its tips have two planes that nearly face each other.
Mesh wedge(Random& random) {
  const double half = 0.5 * random.between(0.15, 0.5);  // radians
  const double cut = random.between(-0.6, 0.4);
  Mesh mesh;
  for (const double end : {0.0, 1.0}) {
    const double slant = end == 0 ? cut : -cut;
    mesh.positions.emplace_back(0, 0, end);
    mesh.positions.emplace_back(std::cos(half), -std::sin(half), end + slant);
    mesh.positions.emplace_back(std::cos(half), std::sin(half), end + slant);
  }
  mesh.triangles = {{0, 2, 1}, {3, 4, 5}, {0, 1, 4}, {0, 4, 3},
                    {1, 2, 5}, {1, 5, 4}, {2, 0, 3}, {2, 3, 5}};
  return turned(mesh, random);
}

TEST(Corners, OfWedgesAreMet) {
  constexpr double kWithin = 0.01;
  Random random(11);
  for (int number = 0; number < 200; ++number) {
    const Mesh mesh = wedge(random);
    ASSERT_GT(shapes::signed_volume(mesh), 0);
    const Grid grid = build_grid(mesh, {.tolerance = kWithin});
    const Mesh out = extract(grid, {.strict = Strict::kManifold});
    EXPECT_LT(gap(mesh.positions, out.positions), kWithin) << number;
  }
}

TEST(Corners, AreKeptWhereAPlaneIsMissingOnly) {
  Random random(2);
  int tips = 0;
  for (int i = 0; i < 2 * kRotations; ++i) {
    const Mesh cube = turned(shapes::cube(), random);
    const Grid built = build_grid(cube, {.strategy = SplitStrategy::kUniform, .depth = 12});
    const GridData& grid = built.data();
    EXPECT_NO_THROW(validate(grid));
    for (const KeptCorner& corner : grid.corners) {
      const Index loops = grid.start_leaf(corner.half_edge);
      const Index own = leaf_of(grid, corner.point);
      tips += loops != own ? 1 : 0;
      EXPECT_TRUE(loops != own || !shown(grid, own));
      EXPECT_LT(gap({grid.lattice.to_model(corner.point)}, cube.positions), 1e-9)
          << "not rounded to the lattice";
    }
    for (const Vec3& p : cube.positions) {
      const Vec3 at = grid.lattice.to_lattice(p);
      const auto is_kept = [&](const KeptCorner& corner) { return (corner.point - at).norm() < 1; };
      EXPECT_EQ(std::count_if(grid.corners.begin(), grid.corners.end(), is_kept),
                shown(grid, leaf_of(grid, at)) ? 0 : 1);
    }
  }
  EXPECT_GT(tips, 0) << "in leaves without hits";
}

// There every vertex is within its leaf, or triangles might cross.
TEST(Corners, BeyondLeavesAreNotMetByEmbeddedResults) {
  Random random(2);
  for (int i = 0; i < kRotations; ++i) {
    const Mesh cube = turned(shapes::cube(), random);
    const Grid grid = build_grid(cube, {.strategy = SplitStrategy::kUniform, .depth = 12});
    const Mesh out = extract(grid, {.strict = Strict::kEmbedded});
    EXPECT_TRUE(check::is_two_manifold(out));
    EXPECT_EQ(find_self_intersections(out).pairs, 0u);
  }
}

TEST(Corners, AreNotKeptOfWhatIsMerelyCurved) {
  for (const Mesh& mesh : {shapes::torus(), shapes::icosphere(3), shapes::uv_sphere(40, 20)}) {
    for (const SplitStrategy strategy : {SplitStrategy::kUniform, SplitStrategy::kAdaptive}) {
      EXPECT_TRUE(build_grid(mesh, {.strategy = strategy, .depth = 12}).data().corners.empty());
    }
  }
}

// Both sides of a wall have corners in leaves that they share: each has its own.
TEST(Corners, OfThinWallsStayOnTheirSide) {
  Random random(3);
  std::size_t kept = 0;
  for (int i = 0; i < kRotations; ++i) {
    const Mesh box = turned(shapes::thin_walled_box(0.01), random);
    const Grid grid = build_grid(box, {.strategy = SplitStrategy::kUniform, .depth = 12});
    kept += grid.data().corners.size();
    for (std::size_t k = 1; k < grid.data().corners.size(); ++k) {
      for (std::size_t j = 0; j < k; ++j) {
        EXPECT_NE(grid.data().corners[j].point, grid.data().corners[k].point);
      }
    }
    const Mesh out = extract(grid, {.strict = Strict::kEmbedded});
    EXPECT_TRUE(check::is_two_manifold(out));
    EXPECT_EQ(find_self_intersections(out).pairs, 0u);
  }
  EXPECT_GT(kept, 0u);
}

}  // namespace
}  // namespace kdm
