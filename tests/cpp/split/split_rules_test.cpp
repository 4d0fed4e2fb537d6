// SPDX-License-Identifier: MIT
// What each split strategy promises of the tree and of the result.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "geometry/distance.h"
#include "geometry/predicates.h"
#include "grid/grid_data.h"
#include "grid/validate.h"
#include "kdmanifold/build.h"
#include "kdmanifold/extract.h"
#include "support/mesh_assert.h"
#include "support/random.h"
#include "support/random_meshes.h"
#include "support/shapes.h"

namespace kdm {
namespace {

constexpr std::array<SplitStrategy, 5> kStrategies{SplitStrategy::kAdaptive, SplitStrategy::kOctree,
                                                   SplitStrategy::kFeature, SplitStrategy::kMedian,
                                                   SplitStrategy::kUniform};

struct Leaf {
  Index cell = 0;
  int depth = 0;
};

// The leaf that holds a point, given in lattice coordinates.
Leaf leaf_at(const GridData& grid, const Vec3& p) {
  Leaf leaf;
  while (!grid.cells[leaf.cell].leaf()) {
    const Cell& cell = grid.cells[leaf.cell];
    leaf.cell = p[cell.axis()] <= cell.value() ? cell.below() : cell.above();
    ++leaf.depth;
  }
  return leaf;
}

// Random points of the mesh's surface, with their triangles.
std::vector<std::pair<Vec3, Index>> surface_points(const Mesh& mesh, int each) {
  check::Random random(1);
  std::vector<std::pair<Vec3, Index>> points;
  for (Index t = 0; t < mesh.triangles.size(); ++t) {
    const auto& [a, b, c] = mesh.triangles[t];
    for (int i = 0; i < each; ++i) {
      double u = random.unit();
      double v = random.unit();
      if (u + v > 1) {
        u = 1 - u;
        v = 1 - v;
      }
      points.emplace_back(mesh.positions[a] + u * (mesh.positions[b] - mesh.positions[a]) +
                              v * (mesh.positions[c] - mesh.positions[a]),
                          t);
    }
  }
  return points;
}

int deepest(const GridData& grid) {
  std::vector<int> depth(grid.cells.size(), 0);
  for (std::size_t c = 0; c < grid.cells.size(); ++c) {
    const Cell& cell = grid.cells[c];
    if (!cell.leaf()) depth[cell.below()] = depth[cell.above()] = depth[c] + 1;
  }
  return *std::max_element(depth.begin(), depth.end());
}

Mesh tilted(const Mesh& mesh) { return shapes::rotated(mesh, Vec3(1, 2, 3), 0.7); }

TEST(SplitRules, NoneGoesBelowTheDepthLimit) {
  for (const Mesh& mesh : {shapes::cube(), tilted(shapes::torus(1, 0.4, 16, 8)),
                           shapes::random_tetrahedra(4, 1), shapes::integer_tetrahedra(6, 3, 1)}) {
    for (const SplitStrategy strategy : kStrategies) {
      for (const int depth : {1, 2, 3, 7, 10}) {
        const Grid grid = build_grid(mesh, {.strategy = strategy, .depth = depth});
        EXPECT_LE(deepest(grid.data()), depth);
        EXPECT_EQ(grid.stats().depth, deepest(grid.data()));
        EXPECT_EQ(grid.stats().cells, 2 * grid.stats().leaves - 1);
        EXPECT_EQ(grid.stats().cells, grid.data().cells.size());
        EXPECT_EQ(grid.stats().hits, grid.data().hits.size());
        EXPECT_GT(grid.stats().bytes, 8 * grid.stats().cells + 32 * grid.stats().hits);
      }
    }
  }
}

// --- Uniform -------------------------------------------------------------------------------------

TEST(SplitRules, UniformGoesToTheFullDepthAtTheSurface) {
  const Mesh mesh = tilted(shapes::torus(1, 0.4, 16, 8));
  for (const int depth : {1, 5, 9, 12}) {
    const Grid grid = build_grid(mesh, {.strategy = SplitStrategy::kUniform, .depth = depth});
    for (const auto& [point, triangle] : surface_points(mesh, 10)) {
      ASSERT_EQ(leaf_at(grid.data(), grid.data().lattice.to_lattice(point)).depth, depth);
    }
  }
}

// Every split halves its cell along the axis whose turn it is.
void expect_midpoints_in_turn(const GridData& grid) {
  const std::vector<LatticeBox> boxes = cell_boxes(grid);
  std::vector<int> depth(grid.cells.size(), 0);
  for (std::size_t c = 0; c < grid.cells.size(); ++c) {
    const Cell& cell = grid.cells[c];
    if (cell.leaf()) continue;
    depth[cell.below()] = depth[cell.above()] = depth[c] + 1;
    ASSERT_EQ(cell.axis(), depth[c] % 3);
    ASSERT_EQ(2 * cell.value(), boxes[c].lo[cell.axis()] + boxes[c].hi[cell.axis()]);
  }
}

TEST(SplitRules, UniformAndOctreeSplitAtMidpointsInTurn) {
  const Mesh mesh = tilted(shapes::torus(1, 0.4, 16, 8));
  const Grid uniform = build_grid(mesh, {.strategy = SplitStrategy::kUniform, .depth = 10});
  expect_midpoints_in_turn(uniform.data());
  EXPECT_LT(uniform.stats().leaves, 1u << 9) << "cells without surface are left whole";
  expect_midpoints_in_turn(
      build_grid(mesh, {.strategy = SplitStrategy::kOctree, .relative_tolerance = 0.01}).data());
}

// --- Octree --------------------------------------------------------------------------------------

TEST(SplitRules, OctreeLeavesPlaneCellsWhole) {
  const Mesh cube = tilted(shapes::cube());
  const Grid full = build_grid(cube, {.strategy = SplitStrategy::kUniform, .depth = 15});
  const Grid grid =
      build_grid(cube, {.strategy = SplitStrategy::kOctree, .relative_tolerance = 0, .depth = 15});
  EXPECT_LT(20 * grid.stats().leaves, full.stats().leaves);
  for (const auto& [point, triangle] : surface_points(shapes::cube(), 50)) {
    // The middle of a side is plane far around it.
    if ((point - Vec3::Constant(0.5)).norm() > 0.55) continue;
    Mesh one_point;
    one_point.positions = {point};
    const Vec3 turned = shapes::rotated(one_point, Vec3(1, 2, 3), 0.7).positions[0];
    EXPECT_LE(leaf_at(grid.data(), grid.data().lattice.to_lattice(turned)).depth, 9);
  }
}

TEST(SplitRules, OctreeFollowsCurvature) {
  const Mesh sphere = shapes::icosphere(3);
  Index last = 0;
  for (const double tolerance : {0.05, 0.01, 0.002}) {
    const Grid grid =
        build_grid(sphere, {.strategy = SplitStrategy::kOctree, .tolerance = tolerance});
    EXPECT_GT(grid.stats().leaves, 2 * last) << "a smaller tolerance takes more leaves";
    last = grid.stats().leaves;
  }
}

// --- Median --------------------------------------------------------------------------------------

// Triangles of the input that no hit names.
std::vector<Index> not_hit(const Mesh& mesh, const GridData& grid) {
  std::vector<char> hit(mesh.triangles.size(), 0);
  for (const Hit& h : grid.hits) hit[grid.source_faces[h.plane()]] = 1;
  std::vector<Index> rest;
  for (Index t = 0; t < mesh.triangles.size(); ++t) {
    if (hit[t] == 0) rest.push_back(t);
  }
  return rest;
}

TEST(SplitRules, MedianGoesOnUntilEveryTriangleIsHit) {
  for (const Mesh& mesh :
       {shapes::cube(), tilted(shapes::cube()),
        shapes::subdivided(shapes::subdivided(shapes::cube())), shapes::icosphere(2),
        shapes::torus(1, 0.4, 24, 12), shapes::stairs(4), shapes::plate_with_holes(3, 2),
        tilted(shapes::glass(0.02)), shapes::swiss_cheese(4), shapes::thin_walled_box(0.01)}) {
    const Grid grid = build_grid(mesh, {.strategy = SplitStrategy::kMedian, .depth = 60});
    ASSERT_LT(grid.stats().depth, 60);
    EXPECT_EQ(not_hit(mesh, grid.data()), std::vector<Index>());
  }
}

TEST(SplitRules, MedianStopsEarlierOnlyAtTheDepthLimit) {
  const Mesh mesh = tilted(shapes::torus(1, 0.4, 24, 12));
  for (const int depth : {4, 7, 9}) {
    const Grid grid = build_grid(mesh, {.strategy = SplitStrategy::kMedian, .depth = depth});
    const std::vector<Index> rest = not_hit(mesh, grid.data());
    EXPECT_FALSE(rest.empty()) << "the limit is felt";
    for (const Index t : rest) {
      // The cell that holds the triangle's centre, rounded down as the rule does.
      LatticePoint centre{};
      for (const Index v : mesh.triangles[t]) {
        const LatticePoint p = grid.data().lattice.quantise(mesh.positions[v]);
        for (int k = 0; k < 3; ++k) centre[k] += p[k];
      }
      const Vec3 rounded(centre[0] / 3, centre[1] / 3, centre[2] / 3);
      EXPECT_EQ(leaf_at(grid.data(), rounded).depth, depth) << "triangle " << t;
    }
  }
}

TEST(SplitRules, MedianHalvesTheTriangles) {
  const Mesh mesh = shapes::icosphere(4);
  const Grid handle = build_grid(mesh, {.strategy = SplitStrategy::kMedian});
  const GridData& grid = handle.data();
  Index below = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    const Vec3 centre = (mesh.positions[a] + mesh.positions[b] + mesh.positions[c]) / 3;
    const double x = grid.lattice.to_lattice(centre)[grid.cells[0].axis()];
    below += x < grid.cells[0].value() ? 1 : 0;
  }
  const auto triangles = static_cast<double>(mesh.triangles.size());
  EXPECT_NEAR(below, triangles / 2, triangles * 0.05);
  // Log2 of the triangles and the splits in three directions that each of the last ones needs.
  EXPECT_LE(grid.stats.depth, 13 + 6);
}

// --- Adaptive ------------------------------------------------------------------------------------

TEST(SplitRules, AdaptiveMeetsItsToleranceWithFewFaces) {
  const Mesh sphere = shapes::icosphere(4);
  std::size_t last = 0;
  for (const double tolerance : {0.05, 0.02, 0.005}) {
    const Grid grid = build_grid(sphere, {.tolerance = tolerance});
    EXPECT_TRUE(grid.stats().topology_resolved);
    EXPECT_EQ(grid.stats().unresolved_leaves, 0u);
    const ExtractedMesh out = extract(grid);
    for (const Vec3& p : out.positions) {
      ASSERT_LE(std::abs(p.norm() - 1), tolerance + 0.005) << "the input is off by up to 0.003";
    }
    EXPECT_GT(out.triangles.size(), last);
    last = out.triangles.size();
  }
}

// Largest distance from edges between faces that turn by more than 60 degrees to the result.
double sharp_edge_distance(const Mesh& mesh, const Mesh& result) {
  std::map<std::pair<Index, Index>, std::vector<Vec3>> normals;
  for (const Triangle& t : mesh.triangles) {
    const Vec3& p = mesh.positions[t[0]];
    const Vec3 normal = (mesh.positions[t[1]] - p).cross(mesh.positions[t[2]] - p).normalized();
    for (std::size_t i = 0; i < 3; ++i) {
      normals[std::minmax(t[i], t[(i + 1) % 3])].push_back(normal);
    }
  }
  double furthest = -1;
  for (const auto& [edge, sides] : normals) {
    if (sides[0].dot(sides[1]) > 0.5) continue;
    const Vec3& a = mesh.positions[edge.first];
    const Vec3& b = mesh.positions[edge.second];
    for (const double part : {0.0, 0.25, 0.5, 0.75}) {
      const Vec3 point = a + part * (b - a);
      double least = std::numeric_limits<double>::infinity();
      for (const Triangle& t : result.triangles) {
        least = std::min(least, squared_distance(point, result.positions[t[0]],
                                                 result.positions[t[1]], result.positions[t[2]]));
      }
      furthest = std::max(furthest, std::sqrt(least));
    }
  }
  return furthest;
}

// Near both faces of an edge is not near the edge, and an acute one may lie beyond the face of a
// link. The last of each were 1.2 and 10 times the tolerance off.
TEST(SplitRules, AdaptiveKeepsCurvedRimsWithinTheTolerance) {
  const auto check = [](const Mesh& mesh, double angle) {
    SCOPED_TRACE(testing::Message() << "turned by " << angle);
    const Mesh turned = shapes::rotated(mesh, Vec3(1, 2, 3), angle);
    for (const double tolerance : {0.05, 0.02, 0.008, 0.003}) {
      const double off =
          sharp_edge_distance(turned, extract(build_grid(turned, {.tolerance = tolerance})));
      EXPECT_GE(off, 0) << "there are such edges";
      EXPECT_LE(off, tolerance);
    }
  };
  const Mesh drum = shapes::cylinder(1, 0.7, 40);
  for (const double angle : {1.3, 4.3, 7.3}) check(drum, angle);
  const Mesh lens = shapes::revolved({{0, 0}, {1, 0.4}, {0, 0.8}}, 96);
  for (const double angle : {2.3, 28.3, 18.3}) check(lens, angle);
}

TEST(SplitRules, AdaptiveResolvesTheTopologyOfEmbeddedInput) {
  for (const Mesh& mesh :
       {tilted(shapes::thin_walled_box(0.02)), tilted(shapes::torus(1, 0.1, 24, 8)),
        tilted(shapes::torus_chain(2)), tilted(shapes::plate_with_holes(2, 1)),
        tilted(shapes::swiss_cheese(3))}) {
    const check::MeshCheck input = check::check_mesh(mesh);
    const Grid grid = build_grid(mesh, {.relative_tolerance = 0.05});
    EXPECT_TRUE(grid.stats().topology_resolved);
    const check::MeshCheck result = check::check_mesh(extract(grid));
    EXPECT_TRUE(result.two_manifold) << result.faults();
    EXPECT_EQ(result.components, input.components);
    EXPECT_EQ(result.euler_characteristic, input.euler_characteristic);
  }
}

// A closed part that four cells round one edge could hold between them: it needs an edge of its own
// in another direction, or it comes out as two triangles back to back.
TEST(SplitRules, AdaptiveKeepsPartsSmallerThanTheTolerance) {
  const Mesh scene = shapes::merged(
      {shapes::cube(), shapes::box(Vec3(2.001, 2.002, 2.003), Vec3(2.011, 2.012, 2.013))});
  const Grid grid = build_grid(scene, {.relative_tolerance = 0.01});
  EXPECT_TRUE(grid.stats().topology_resolved);
  const ExtractedMesh out = extract(grid);
  EXPECT_EQ(out.report.dropped_pillows, 0u);
  EXPECT_EQ(check::check_mesh(out).components, 2);
}

TEST(SplitRules, WhatIsGivenUpIsReported) {
  const Grid grid =
      build_grid(tilted(shapes::thin_walled_box(0.01)), {.relative_tolerance = 1e-4, .depth = 6});
  EXPECT_FALSE(grid.stats().topology_resolved);
  EXPECT_GT(grid.stats().unresolved_leaves, 0u);
  EXPECT_EQ(grid.stats().unresolved_positions.size(), grid.stats().unresolved_leaves);
  for (const SplitStrategy strategy : {SplitStrategy::kMedian, SplitStrategy::kUniform}) {
    const Grid other = build_grid(shapes::cube(), {.strategy = strategy, .depth = 6});
    EXPECT_FALSE(other.stats().topology_resolved) << "these do not look";
    EXPECT_EQ(other.stats().unresolved_leaves, 0u);
  }
}

// Two spheres cross in a circle: there, and only there, topology is given up.
TEST(SplitRules, PositionsTellWhereTopologyWasGivenUp) {
  const Mesh spheres = shapes::merged(
      {shapes::icosphere(4), shapes::translated(shapes::icosphere(4), Vec3(1, 0, 0))});
  for (const double tolerance : {0.002, 0.0005}) {
    const GridStats stats = build_grid(spheres, {.tolerance = tolerance}).stats();
    ASSERT_GT(stats.unresolved_leaves, 0u);
    const std::size_t kept = stats.unresolved_positions.size();
    EXPECT_LE(kept, 1000u);
    EXPECT_GE(kept, std::min<std::size_t>(stats.unresolved_leaves, 500));
    for (const Vec3& p : stats.unresolved_positions) {
      EXPECT_NEAR(p.x(), 0.5, 0.2);
      EXPECT_NEAR(std::hypot(p.y(), p.z()), std::sqrt(0.75), 0.2);
    }
  }
}

// --- Volumes -------------------------------------------------------------------------------------

double volume_error(const Mesh& mesh, const BuildOptions& options) {
  const check::MeshCheck result = check::check_mesh(extract(build_grid(mesh, options)));
  EXPECT_TRUE(result.two_manifold) << result.faults();
  const double volume = shapes::signed_volume(mesh);
  return std::abs(result.volume - volume) / volume;
}

TEST(SplitRules, ACubeKeepsItsVolume) {
  for (const Mesh& cube :
       {shapes::cube(), shapes::translated(shapes::cube(), Vec3(0.3, 7, -2)),
        shapes::scaled(shapes::cube(), Vec3(1, 0.7, 0.4)), shapes::subdivided(shapes::cube())}) {
    EXPECT_LT(volume_error(cube, {.strategy = SplitStrategy::kOctree, .depth = 9}), 1e-5);
    EXPECT_LT(volume_error(cube, {}), 1e-5);
  }
}

TEST(SplitRules, ATurnedCubeKeepsItsVolumeBetterTheDeeperTheOctree) {
  for (const Vec3& axis : {Vec3(1, 2, 3), Vec3(0, 0, 1), Vec3(-2, 1, 0.5), Vec3(1, 1, 1)}) {
    const Mesh cube = shapes::rotated(shapes::cube(), axis, 0.6);
    const auto error = [&](int depth) {
      return volume_error(
          cube, {.strategy = SplitStrategy::kOctree, .relative_tolerance = 0, .depth = depth});
    };
    const double coarse = error(9);
    const double fine = error(12);
    const double finest = error(15);
    EXPECT_LT(coarse, 0.02);
    EXPECT_LE(fine, coarse);
    EXPECT_LE(finest, fine);
    EXPECT_LT(finest, 1e-3);
  }
}

}  // namespace
}  // namespace kdm
