// SPDX-License-Identifier: MIT
// Parts of one mesh that touch, coincide or overlap: nothing is lost, nothing comes out twice.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "kdmanifold/account.h"
#include "kdmanifold/build.h"
#include "kdmanifold/extract.h"
#include "support/mesh_check.h"
#include "support/random.h"
#include "support/shapes.h"

namespace kdm {
namespace {

using shapes::box;

struct Result {
  check::MeshCheck report;
  bool resolved = false;
  std::size_t triangles = 0;
};

Result convert(const Mesh& mesh, Strict strict, double tolerance = 0.002) {
  const Grid grid = build_grid(mesh, {.relative_tolerance = tolerance});
  const ExtractedMesh out = extract(grid, {.strict = strict});
  EXPECT_EQ(out.report.crossings.value_or(0), 0u);
  return {check::check_mesh(out), grid.stats().topology_resolved, out.triangles.size()};
}

// The solid keeps its volume, however the mesh is turned and whether or not it must be embedded.
void expect_volume(const Mesh& mesh, double volume, double share) {
  for (const Mesh& posed : {mesh, shapes::turned(mesh)}) {
    for (const Strict strict : {Strict::kManifold, Strict::kEmbedded}) {
      const Result result = convert(posed, strict);
      EXPECT_TRUE(result.report.two_manifold);
      EXPECT_NEAR(result.report.volume, volume, share * volume);
    }
  }
}

TEST(Contacts, CubesThatShareAnEdgeStayWhole) { expect_volume(shapes::cubes_at_edge(), 2, 0.002); }

TEST(Contacts, CubesThatShareAVertexStayWhole) {
  expect_volume(shapes::cubes_at_vertex(), 2, 0.002);
}

// The profile leads from the axis up and back to it: both cones have their apex in the origin,
// where the first cells meet.
TEST(Contacts, AProfileThatTouchesItsAxisStaysWhole) {
  const Mesh cup = shapes::revolved({{1, 1}, {1, 2}, {0, 0}}, 4);
  expect_volume(cup, 4.0 / 3, 0.01);
}

TEST(Contacts, BoxesFaceToFaceAreOneSolidWhereverTheyPoint) {
  const Mesh steps =
      shapes::merged({box(Vec3(0, 0, 0), Vec3(3, 1, 1)), box(Vec3(0, 1, 0), Vec3(2, 2, 1)),
                      box(Vec3(0, 2, 0), Vec3(1, 3, 1))});
  expect_volume(steps, 6, 0.002);
  const Result result = convert(shapes::turned(steps), Strict::kEmbedded);
  EXPECT_EQ(result.report.components, 1);
  EXPECT_EQ(result.report.euler_characteristic, 2);
}

TEST(Contacts, CoplanarFacesCostNothing) {
  EXPECT_LE(convert(shapes::face_to_face_cubes(), Strict::kManifold).triangles, 24u);
  const Mesh overlap =
      shapes::merged({box(Vec3(0, 0, 0), Vec3(1.001, 1, 1)), box(Vec3(1, 0, 0), Vec3(2, 1, 1))});
  EXPECT_LE(convert(overlap, Strict::kManifold).triangles, 48u);
}

TEST(Contacts, ABoxThatIsThereTwiceCountsOnce) {
  const Mesh twice = shapes::merged({shapes::cube(), shapes::cube()});
  const Result result = convert(twice, Strict::kManifold);
  EXPECT_EQ(result.triangles, 12u);
  EXPECT_TRUE(result.resolved);
  EXPECT_EQ(build_grid(twice, {}).input().duplicate_faces, 12u);
  // A copy of one side is no copy of a part: the mesh is not closed then, or another solid.
  EXPECT_EQ(build_grid(shapes::face_to_face_cubes(), {}).input().duplicate_faces, 0u);
}

// Two of the five cubes touch along an edge that lies in the side of a cell. An edge of the mesh
// there joins two vertices twice, and the vertex that parts the two edges lies on the contact, not
// amid hits whose line lies in the next face.
TEST(Contacts, WhatPartsDoubledEdgesLiesOnTheContact) {
  const std::vector<std::array<int, 3>> cubes = {
      {1, 2, 0}, {1, 0, 1}, {0, 1, 1}, {1, 2, 1}, {1, 0, 2}};
  Mesh mesh = shapes::voxels(2, 3, 3, [&](int x, int y, int z) {
    return std::find(cubes.begin(), cubes.end(), std::array{x, y, z}) != cubes.end();
  });
  for (Vec3& p : mesh.positions) {
    p = 0.4525339526007883 * p - Vec3(1.5649189983885115, 2.9955383847537997, 3.5285828311761369);
  }
  check::Random random(1);
  for (int order = 0; order < 16; ++order) {
    // Other diagonals, and another order of the squares.
    for (Index i = 0; i < mesh.triangles.size(); i += 2) {
      const Index other = 2 * random.below(i / 2 + 1);
      std::swap(mesh.triangles[i], mesh.triangles[other]);
      std::swap(mesh.triangles[i + 1], mesh.triangles[other + 1]);
    }
    for (Index i = 0; i < mesh.triangles.size(); i += 2) {
      const auto [p, q, r] = mesh.triangles[i];
      if (random.coin()) continue;
      const Index s = mesh.triangles[i + 1][2];
      mesh.triangles[i] = {q, r, s};
      mesh.triangles[i + 1] = {q, s, p};
    }
    const Grid grid = build_grid(mesh, {.relative_tolerance = 0.01});
    const MeshError error = *compare(mesh, grid, extract(grid), {.error = true}).error;
    EXPECT_LT(error.to_input.largest, 1.5 * grid.stats().tolerance) << order;
    EXPECT_LT(error.to_output.largest, 1.5 * grid.stats().tolerance) << order;
  }
}

// A part within another bounds nothing: it costs no triangle and leaves the topology certain.
TEST(Contacts, NestedPartsLookLikeTheOuterOne) {
  const Mesh nested =
      shapes::merged({box(Vec3(0, 0, 0), Vec3(2, 2, 2)),
                      shapes::translated(shapes::icosphere(3, 0.5), Vec3(1, 1, 1))});
  const Result result = convert(nested, Strict::kManifold);
  EXPECT_TRUE(result.resolved);
  EXPECT_NEAR(result.report.volume, 8, 1e-6);
}

// The walls on either side of a slit that is narrower than a thirty-second of the tolerance grow
// together, and the grid does not say that it kept the topology.
TEST(Contacts, GapsThatAreClosedAreNotCalledResolved) {
  const Mesh walls = shapes::turned(
      shapes::merged({box(Vec3(0, 0, 0), Vec3(1, 1, 1)), box(Vec3(1.0001, 0, 0), Vec3(2, 1, 1))}));
  const Result closed = convert(walls, Strict::kManifold, 0.01);
  EXPECT_EQ(closed.report.components, 1);
  EXPECT_FALSE(closed.resolved);
  const Result open = convert(walls, Strict::kManifold, 0.0005);
  EXPECT_EQ(open.report.components, 2);
  EXPECT_TRUE(open.resolved);
}

}  // namespace
}  // namespace kdm
