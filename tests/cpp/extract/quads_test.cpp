// SPDX-License-Identifier: MIT
// Quads where four leaves meet: all of a uniform grid, some of an octree, and always a manifold.
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "kdmanifold/build.h"
#include "kdmanifold/extract.h"
#include "support/mesh_assert.h"
#include "support/random_meshes.h"
#include "support/shapes.h"

namespace kdm {
namespace {

// With quads no vertices are split or added to links, and no edges flipped.
constexpr ExtractOptions kPlain{
    .split_error = 1e9, .unfold = false, .link_error = 1e9, .strict = Strict::kManifold};

const BuildOptions kUniform{.strategy = SplitStrategy::kUniform, .depth = 12};

TEST(Quads, AUniformGridGivesNothingElse) {
  for (const Mesh& mesh : {shapes::icosphere(3), shapes::cube(), shapes::torus(1, 0.4, 32, 16)}) {
    const Grid grid = build_grid(mesh, kUniform);
    const ExtractedMesh quads = extract(grid, {.quads = true});
    EXPECT_EQ(quads.report.inserted_vertices, 0u);
    EXPECT_EQ(quads.report.dropped_pillows, 0u);
    EXPECT_TRUE(quads.triangles.empty());
    EXPECT_GT(quads.quads.size(), 100u);
    EXPECT_TRUE(check::is_two_manifold(quads));
  }
}

TEST(Quads, AnInsertedVertexTurnsTwoQuadsIntoTriangles) {
  // The corners of a turned cube poke through grid edges just so.
  const Grid grid = build_grid(shapes::rotated(shapes::cube(), Vec3(1, 2, 3), 1), kUniform);
  const ExtractedMesh quads = extract(grid, {.quads = true});
  ASSERT_GT(quads.report.inserted_vertices, 0u);
  EXPECT_GT(quads.triangles.size(), 0u);
  EXPECT_LE(quads.triangles.size(), 6 * quads.report.inserted_vertices);
  EXPECT_TRUE(check::is_two_manifold(quads));
  EXPECT_TRUE(extract(grid, {.quads = true, .strict = Strict::kOff}).triangles.empty());
}

TEST(Quads, WithoutTheOptionThereAreNone) {
  EXPECT_TRUE(extract(build_grid(shapes::icosphere(2), kUniform)).quads.empty());
}

TEST(Quads, AnOctreeMixes) {
  const Grid grid =
      build_grid(shapes::rotated(shapes::torus(), Vec3(1, 2, 3), 1),
                 {.strategy = SplitStrategy::kOctree, .relative_tolerance = 0.005, .depth = 18});
  const ExtractedMesh out = extract(grid, {.quads = true});
  EXPECT_GT(out.quads.size(), 50u);
  EXPECT_GT(out.triangles.size(), 50u);
  EXPECT_TRUE(check::is_two_manifold(out));
}

TEST(Quads, AreTheSameSurface) {
  for (const SplitStrategy strategy :
       {SplitStrategy::kUniform, SplitStrategy::kOctree, SplitStrategy::kMedian}) {
    for (const Mesh& mesh : {shapes::torus(1, 0.4, 16, 8), shapes::plate_with_holes(2, 2),
                             shapes::random_voxels(3, 0.5, 2), shapes::random_tetrahedra(5, 4)}) {
      const Grid grid = build_grid(mesh, {.strategy = strategy, .depth = 11});
      const ExtractedMesh plain = extract(grid, kPlain);
      const ExtractedMesh quads = extract(grid, {.quads = true, .strict = Strict::kManifold});
      EXPECT_EQ(plain.positions, quads.positions);
      EXPECT_EQ(plain.triangles.size(), quads.triangles.size() + 2 * quads.quads.size());
      EXPECT_EQ(plain.source_faces.size(), plain.triangles.size());
      EXPECT_EQ(quads.source_faces.size(), quads.triangles.size() + quads.quads.size());
      const check::MeshCheck a = check::check_mesh(plain);
      const check::MeshCheck b = check::check_mesh(quads);
      EXPECT_TRUE(b.two_manifold) << b.faults();
      EXPECT_EQ(a.euler_characteristic, b.euler_characteristic);
      EXPECT_EQ(a.components, b.components);
      EXPECT_NEAR(a.volume, b.volume, 0.02 * std::abs(a.volume));
    }
  }
}

TEST(Quads, EachIsTwoTrianglesOfThePlainMesh) {
  const Grid grid = build_grid(shapes::torus(1, 0.4, 32, 16),
                               {.strategy = SplitStrategy::kOctree, .relative_tolerance = 0.01});
  const ExtractedMesh plain = extract(grid, kPlain);
  const ExtractedMesh mixed = extract(grid, {.quads = true});
  // Triangles with the smallest corner first, to be found again.
  const auto turned = [](Triangle t) {
    while (t[0] > t[1] || t[0] > t[2]) t = {t[1], t[2], t[0]};
    return t;
  };
  std::map<Triangle, Index> source;
  for (std::size_t i = 0; i < plain.triangles.size(); ++i) {
    source[turned(plain.triangles[i])] = plain.source_faces[i];
  }
  const auto take = [&](const Triangle& t, Index face) {
    const auto found = source.find(turned(t));
    if (found == source.end() || found->second != face) return false;
    source.erase(found);
    return true;
  };
  // Source faces run over the triangles first, then over the quads.
  for (std::size_t i = 0; i < mixed.triangles.size(); ++i) {
    ASSERT_TRUE(take(mixed.triangles[i], mixed.source_faces[i])) << "triangle " << i;
  }
  for (std::size_t i = 0; i < mixed.quads.size(); ++i) {
    const auto& [a, b, c, d] = mixed.quads[i];
    const Index face = mixed.source_faces[mixed.triangles.size() + i];
    const bool one = take({a, b, c}, face) && take({a, c, d}, face);
    ASSERT_TRUE(one || (take({a, b, d}, face) && take({b, c, d}, face))) << "quad " << i;
  }
  EXPECT_GT(mixed.triangles.size(), 0u);
  EXPECT_GT(mixed.quads.size(), 0u);
  EXPECT_TRUE(source.empty());
}

TEST(Quads, NameTheFaceOnWhichTheyLie) {
  Mesh cube = shapes::cube();
  for (Index t = 0; t < 12; ++t) cube.source_faces.push_back(100 + t / 2);
  const std::array<std::pair<int, double>, 6> sides = {
      {{2, 0.0}, {2, 1.0}, {1, 0.0}, {1, 1.0}, {0, 0.0}, {0, 1.0}}};
  const ExtractedMesh out = extract(build_grid(cube, kUniform), {.quads = true});
  ASSERT_EQ(out.source_faces.size(), out.quads.size());
  for (std::size_t i = 0; i < out.quads.size(); ++i) {
    ASSERT_GE(out.source_faces[i], 100u);
    ASSERT_LT(out.source_faces[i], 106u);
    const auto [axis, value] = sides[out.source_faces[i] - 100];
    for (const Index v : out.quads[i]) ASSERT_NEAR(out.positions[v][axis], value, 1e-4);
  }
}

TEST(Quads, GoIntoAGridAgain) {
  const ExtractedMesh quads = extract(build_grid(shapes::torus(), kUniform), {.quads = true});
  const Grid again = build_grid(quads, kUniform);
  EXPECT_EQ(again.input().triangles, 2 * quads.quads.size());
  EXPECT_TRUE(check::is_two_manifold(extract(again)));
}

}  // namespace
}  // namespace kdm
