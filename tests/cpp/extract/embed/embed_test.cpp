// SPDX-License-Identifier: MIT
// Results that do not meet themselves.
#include "extract/embed/embed.h"

#include <gtest/gtest.h>

#include "extract/place/place.h"
#include "extract/place/refine.h"
#include "kdmanifold/account.h"
#include "kdmanifold/build.h"
#include "kdmanifold/error.h"
#include "kdmanifold/extract.h"
#include "support/dual_mesh_check.h"
#include "support/mesh_assert.h"
#include "support/random_meshes.h"
#include "support/sanitized.h"
#include "support/shapes.h"

namespace kdm {
namespace {

constexpr ExtractOptions kEmbedded{.strict = Strict::kEmbedded};
constexpr ExtractOptions kManifold{.strict = Strict::kManifold};

std::vector<Mesh> models() {
  return {shapes::rotated(shapes::stairs(4), Vec3(1, 2, 3), 0.7),
          shapes::rotated(shapes::plate_with_holes(2, 2), Vec3(3, 1, 2), 1),
          shapes::glass(0.02),
          shapes::swiss_cheese(5),
          shapes::torus_chain(2),
          shapes::rotated(shapes::thin_walled_box(1.0 / 50), Vec3(1, 1, 3), 0.4)};
}

TEST(Embed, NothingCrosses) {
  std::uint64_t plain_crossings = 0;
  Index refined = 0;
  int number = 0;
  for (const Mesh& mesh : models()) {
    for (const BuildOptions& options :
         {BuildOptions{.relative_tolerance = 0.005},
          BuildOptions{
              .strategy = SplitStrategy::kOctree, .relative_tolerance = 0.002, .depth = 12},
          BuildOptions{.strategy = SplitStrategy::kMedian, .depth = 13}}) {
      SCOPED_TRACE(number++);
      const Grid grid = build_grid(mesh, options);
      const ExtractedMesh plain = extract(grid, kManifold);
      EXPECT_FALSE(plain.report.crossings) << "nobody has looked";
      EXPECT_EQ(plain.report.refined_hits, 0u);
      const std::uint64_t before = find_self_intersections(plain).pairs;
      plain_crossings += before;
      const ExtractedMesh out = extract(grid, kEmbedded);
      ASSERT_TRUE(out.report.crossings);
      EXPECT_EQ(*out.report.crossings, find_self_intersections(out).pairs);
      EXPECT_EQ(*out.report.crossings, 0u);
      EXPECT_TRUE(check::is_two_manifold(out));
      // Thin models have no hits at all.
      EXPECT_LT(2 * out.report.refined_hits, std::max<Index>(grid.stats().hits, 1));
      refined += out.report.refined_hits;
      const MeshReport shape = describe(out);
      EXPECT_EQ(shape.components, describe(plain).components);
      EXPECT_EQ(shape.euler_characteristic, describe(plain).euler_characteristic);
    }
  }
  EXPECT_GT(plain_crossings, 50u);
  EXPECT_GT(refined, 30u);
}

// On a grid far too coarse leaves hold many loops; fans round vertices of theirs would cross.
TEST(Embed, SeveralLoopsInALeaf) {
  std::size_t crowded = 0;
  for (std::uint32_t seed = 0; seed < (check::kSanitized ? 2 : 6); ++seed) {
    for (const int depth : {6, 9}) {
      SCOPED_TRACE(testing::Message() << "seed " << seed << ", depth " << depth);
      const Mesh mesh = shapes::random_tetrahedra(30, seed);
      const Grid grid =
          build_grid(mesh, {.strategy = SplitStrategy::kUniform,
                            .depth = depth,
                            .pairing = seed % 2 == 0 ? Pairing::kTrace : Pairing::kInside});
      const ExtractedMesh out = extract(grid, kEmbedded);
      EXPECT_EQ(*out.report.crossings, find_self_intersections(out).pairs);
      EXPECT_EQ(*out.report.crossings, 0u);
      EXPECT_TRUE(check::is_two_manifold(out));
      const MeshReport plain = describe(extract(grid));
      const MeshReport shape = describe(out);
      EXPECT_EQ(shape.components, plain.components);
      EXPECT_EQ(shape.euler_characteristic, plain.euler_characteristic);
      DualMesh dual = dual_mesh_of(grid.data());
      find_loops(grid.data(), dual);
      find_loops_of_leaves(grid.data(), dual);
      for (Index v = 0; v < dual.next_loop_in_leaf.size(); ++v)
        crowded += dual.next_loop_in_leaf[v] != v ? 1 : 0;
    }
  }
  EXPECT_GT(crowded, check::kSanitized ? 30u : 100u);
}

// Voxels that touch along edges: no result with that surface keeps clear of itself.
TEST(Embed, WhatIsLeftIsSaid) {
  const Grid grid = build_grid(shapes::random_voxels(4, 0.5, 3),
                               {.strategy = SplitStrategy::kMedian, .depth = 13});
  const ExtractedMesh out = extract(grid, kEmbedded);
  EXPECT_TRUE(check::is_two_manifold(out));
  EXPECT_EQ(*out.report.crossings, find_self_intersections(out).pairs);
  EXPECT_LT(*out.report.crossings, find_self_intersections(extract(grid, kManifold)).pairs);
}

TEST(Embed, CoordinatesFitIn32Bits) {
  const Mesh far = shapes::translated(shapes::rotated(shapes::stairs(3), Vec3(1, 2, 3), 0.7),
                                      Vec3(100, 200, 300));
  const ExtractedMesh out = extract(build_grid(far), kEmbedded);
  for (const Vec3& p : out.positions) {
    EXPECT_EQ(p, p.cast<float>().cast<double>().eval());
  }
  EXPECT_EQ(*out.report.crossings, 0u);
}

TEST(Embed, WhatDoesNotCrossStays) {
  const Grid grid = build_grid(shapes::rotated(shapes::cube(), Vec3(1, 2, 3), 1));
  const ExtractedMesh plain = extract(grid, kManifold);
  ASSERT_EQ(find_self_intersections(plain).pairs, 0u);
  const ExtractedMesh out = extract(grid, kEmbedded);
  EXPECT_EQ(out.triangles, plain.triangles);
  EXPECT_EQ(out.report.refined_hits, 0u);
}

TEST(Embed, QuadsComeOutAsByManifold) {
  const Grid grid = build_grid(shapes::torus(), {.strategy = SplitStrategy::kUniform, .depth = 12});
  const ExtractedMesh plain = extract(grid, {.quads = true, .strict = Strict::kManifold});
  const ExtractedMesh out = extract(grid, {.quads = true, .strict = Strict::kEmbedded});
  EXPECT_EQ(out.positions, plain.positions);
  EXPECT_EQ(out.quads, plain.quads);
  EXPECT_FALSE(out.report.crossings) << "nobody has looked";
}

// The construction itself: at level kLinksApart every triangle lies in one leaf.
TEST(Embed, LinksApartKeepEachTriangleInItsLeaf) {
  for (const Mesh& mesh : models()) {
    const Grid handle = build_grid(mesh, {.relative_tolerance = 0.01});
    const GridData& grid = handle.data();
    const std::vector<LatticeBox> boxes = cell_boxes(grid);
    const std::vector<Vec3> points = hit_points(grid, boxes);
    const GridView view{grid, boxes, points};
    DualMesh dual = dual_mesh_of(grid);
    find_loops(grid, dual);
    place_vertices(view, {}, dual);
    EditLog log;
    EmbedLevels levels;
    levels.hits.assign(grid.hits.size(), EmbedLevel::kLinksApart);
    levels.loops.assign(dual.vertices(), EmbedLevel::kLinksApart);
    refine(view, levels, 1e9, dual, log);
    check::expect_sound(dual);
    for (Index t = 0; t < dual.triangles(); ++t) {
      int loops = 0;
      Index leaf = kNone;
      for (int i = 0; i < 3; ++i) {
        const Index v = dual.vertex[3 * t + i];
        if (dual.leaf[v] == kNone) continue;
        leaf = dual.leaf[v];
        ++loops;
      }
      ASSERT_EQ(loops, 1) << "of triangle " << t;
      for (int i = 0; i < 3; ++i) {
        const Vec3& p = dual.position[dual.vertex[3 * t + i]];
        ASSERT_TRUE((p.array() >= to_vec3(boxes[leaf].lo).array()).all());
        ASSERT_TRUE((p.array() <= to_vec3(boxes[leaf].hi).array()).all());
      }
    }
  }
}

// To keep clear of others, vertices of links go amid their hits, and back to the crease where
// nothing crosses for that, though one of the two hits may not have been divided.
TEST(Embed, LinksGoBackToTheirCreases) {
  const Mesh mesh = shapes::turned(shapes::random_voxels(4, 0.4, 15));
  const Grid grid = build_grid(mesh, {.relative_tolerance = 0.005});
  const ExtractedMesh out = extract(grid, kEmbedded);
  EXPECT_GT(out.report.refined_hits, 0u);
  const MeshError error = *compare(mesh, grid, out, {.error = true}).error;
  EXPECT_LT(error.to_input.largest, 1.5 * grid.stats().tolerance);
  EXPECT_LT(error.to_output.largest, 1.5 * grid.stats().tolerance);
}

}  // namespace
}  // namespace kdm
