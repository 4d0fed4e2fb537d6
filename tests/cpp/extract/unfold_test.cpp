// SPDX-License-Identifier: MIT
// Edge flips against folds and thin triangles: by hand, and on models.
#include "extract/mend/unfold.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>

#include "extract/mend/triangle_shape.h"
#include "kdmanifold/build.h"
#include "kdmanifold/extract.h"
#include "support/dual_mesh_check.h"
#include "support/dual_mesh_shapes.h"
#include "support/mesh_assert.h"
#include "support/random_meshes.h"
#include "support/shapes.h"

namespace kdm {
namespace {

// A box whose top is four triangles round a vertex; if that lies outside the square, one of them is
// folded over. Triangle t has hit t, whose plane is the box's side.
struct Tent {
  GridData grid;
  DualMesh mesh;
  EditLog log;

  explicit Tent(const Vec3& top) {
    const std::vector<Triangle> triangles = {{4, 5, 8}, {5, 7, 8}, {7, 6, 8}, {6, 4, 8},  // top
                                             {0, 2, 3}, {0, 3, 1}, {0, 1, 5}, {0, 5, 4}, {2, 6, 7},
                                             {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
    mesh = shapes::dual_mesh(triangles);
    find_loops(grid, mesh);
    mesh.position.resize(9);
    for (int v = 0; v < 8; ++v) set(v, Vec3(v & 1, v >> 1 & 1, v >> 2 & 1));
    set(8, top);
    const std::array<Vec3, 6> normals = {Vec3(0, 0, 1), Vec3(0, 0, -1), Vec3(0, -1, 0),
                                         Vec3(0, 1, 0), Vec3(-1, 0, 0), Vec3(1, 0, 0)};
    const std::array<double, 6> offsets = {1, 0, 0, 1, 0, 1};
    const std::array<Index, 14> side = {0, 0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 5, 5};
    for (int i = 0; i < 6; ++i) grid.planes.push_back({normals[i], offsets[i]});
    for (const Index s : side) grid.hits.emplace_back(0u, s, false, false);
  }
  // Vertices are numbered in the order in which loops are found; `leaf` keeps their names.
  void set(Index name, const Vec3& p) {
    for (Index v = 0; v < mesh.leaf.size(); ++v) {
      if (mesh.leaf[v] == name) mesh.position[v] = p;
    }
  }
};

int turned_away(const Tent& tent) {
  int count = 0;
  const Mesh mesh = shapes::index_mesh(tent.mesh);
  for (Index t = 0; t < mesh.triangles.size(); ++t) {
    const auto& [a, b, c] = mesh.triangles[t];
    const Vec3 normal =
        (mesh.positions[b] - mesh.positions[a]).cross(Vec3(mesh.positions[c] - mesh.positions[a]));
    count += normal.dot(tent.grid.planes[tent.grid.hits[tent.mesh.hit[t]].plane()].normal) <= 0;
  }
  return count;
}

TEST(Unfold, BeyondACreaseNothingIsFlipped) {
  Tent tent(Vec3(0.6, -0.5, 1));  // beyond the front edge
  ASSERT_EQ(turned_away(tent), 1);
  tent.grid.tolerance = 0.01;
  const double volume = shapes::signed_volume(shapes::index_mesh(tent.mesh));
  EXPECT_EQ(unfold({tent.grid}, {}, tent.mesh, tent.log), 0u)
      << "another edge would cut the crease";
  EXPECT_EQ(shapes::signed_volume(shapes::index_mesh(tent.mesh)), volume);
}

TEST(Unfold, WhatIsFlatStays) {
  Tent tent(Vec3(0.4, 0.7, 1));
  tent.grid.tolerance = 0.01;
  EXPECT_EQ(turned_away(tent), 0);
  EXPECT_EQ(unfold({tent.grid}, {}, tent.mesh, tent.log), 0u);
  check::expect_sound(tent.mesh);
}

double least_angle_sine(const Tent& tent) {
  const Mesh mesh = shapes::index_mesh(tent.mesh);
  double least = 1;
  for (const auto& [a, b, c] : mesh.triangles) {
    const TriangleShape shape(mesh.positions[a], mesh.positions[b], mesh.positions[c]);
    least = std::min(least, shape.least_sine());
  }
  return least;
}

// The middle one of three vertices in a row along the front edge lies a little off it. The thin
// triangle's plane is the top's; after the flip both are the front's.
TEST(Unfold, ThreeInARowAlongACrease) {
  Tent tent(Vec3(0.4, 0.001, 1));
  ASSERT_LT(least_angle_sine(tent), 0.01);
  const double volume = shapes::signed_volume(shapes::index_mesh(tent.mesh));
  tent.grid.tolerance = 0.0001;
  EXPECT_EQ(unfold({tent.grid}, {}, tent.mesh, tent.log), 0u) << "the vertex is off the front";
  tent.grid.tolerance = 0.01;
  EXPECT_EQ(unfold({tent.grid}, {}, tent.mesh, tent.log), 1u);
  check::expect_sound(tent.mesh);
  EXPECT_GT(least_angle_sine(tent), 0.2);
  EXPECT_EQ(turned_away(tent), 0);
  EXPECT_NEAR(shapes::signed_volume(shapes::index_mesh(tent.mesh)), volume, 0.001);
  int edited = 0;
  for (HitId hit = 0; hit < tent.grid.hits.size(); ++hit) edited += tent.log.edited(hit) ? 1 : 0;
  EXPECT_EQ(edited, 2);
}

std::uint64_t crossings(const Grid& grid, bool unfolded) {
  const ExtractedMesh out = extract(grid, {.unfold = unfolded, .strict = Strict::kManifold});
  EXPECT_TRUE(check::is_two_manifold(out));
  EXPECT_TRUE(unfolded || out.report.flipped_edges == 0);
  return find_self_intersections(out).pairs;
}

TEST(Unfold, TakesAwayMostSelfIntersections) {
  std::uint64_t before = 0;
  std::uint64_t after = 0;
  for (const Mesh& mesh :
       {shapes::rotated(shapes::stairs(4), Vec3(1, 2, 3), 0.7), shapes::plate_with_holes(3, 2),
        shapes::rotated(shapes::plate_with_holes(2, 2), Vec3(3, 1, 2), 1), shapes::glass(0.02),
        shapes::swiss_cheese(5), shapes::torus_chain(2)}) {
    const Grid grid = build_grid(mesh, {.relative_tolerance = 0.005});
    before += crossings(grid, false);
    after += crossings(grid, true);
  }
  EXPECT_GT(before, 20u);
  EXPECT_LT(8 * after, before);
}

// With odd windings shells that face outwards make cavities as shells turned inwards do by default.
TEST(Unfold, CavitiesAreNotTakenForFolds) {
  const Mesh stairs = shapes::rotated(shapes::stairs(4), Vec3(1, 2, 3), 0.7);
  const Mesh around = shapes::box(Vec3(-9, -9, -9), Vec3(9, 9, 9));
  for (const bool round : {true, false}) {
    const Mesh outward = round ? shapes::nested_shells() : shapes::merged({around, stairs});
    const Mesh inward =
        round ? shapes::nested_spheres() : shapes::merged({around, shapes::inverted(stairs)});
    const ExtractedMesh odd =
        extract(build_grid(outward, {.relative_tolerance = 0.002, .inside = InsideRule::kOdd}));
    const ExtractedMesh usual = extract(build_grid(inward, {.relative_tolerance = 0.002}));
    EXPECT_EQ(odd.report.flipped_edges, usual.report.flipped_edges);
    EXPECT_EQ(odd.report.split_vertices, usual.report.split_vertices);
    EXPECT_EQ(odd.triangles, usual.triangles);
    EXPECT_TRUE(round || usual.report.flipped_edges > 0);
  }
}

TEST(Unfold, TopologyAndVerticesStay) {
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    const Grid grid = build_grid(shapes::random_voxels(4, 0.5, seed),
                                 {.strategy = SplitStrategy::kMedian, .depth = 12});
    const ExtractedMesh plain = extract(grid, {.unfold = false, .strict = Strict::kManifold});
    const ExtractedMesh flat = extract(grid, {.strict = Strict::kManifold});
    ASSERT_EQ(plain.positions.size(), flat.positions.size());
    for (std::size_t v = 0; v < plain.positions.size(); ++v) {
      // What has no area without flips is given some.
      EXPECT_LE((plain.positions[v] - flat.positions[v]).norm(), grid.stats().tolerance);
    }
    EXPECT_EQ(plain.triangles.size(), flat.triangles.size());
    const check::MeshCheck result = check::check_mesh(flat);
    ASSERT_TRUE(result.two_manifold) << result.faults();
    EXPECT_EQ(result.euler_characteristic, check::check_mesh(plain).euler_characteristic);
  }
}

}  // namespace
}  // namespace kdm
