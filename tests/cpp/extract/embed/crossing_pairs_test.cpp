// SPDX-License-Identifier: MIT
// Crossing pairs found by way of suspects, against all pairs of triangles.
#include "extract/embed/crossing_pairs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "support/dual_mesh_check.h"
#include "support/embed_stage.h"
#include "support/sanitized.h"
#include "support/threads.h"

namespace kdm {
namespace {

using check::embed_models;
using check::EmbedStage;
using check::split_rules;

TEST(CrossingPairs, AreThoseOfAllPairs) {
  std::uint64_t found = 0;
  int number = 0;
  for (const Mesh& model : embed_models()) {
    for (const BuildOptions& options : split_rules()) {
      SCOPED_TRACE(number++);
      EmbedStage stage(model, options);
      stage.make();
      CrossingPairs crossing_pairs(stage.view(), stage.loops, stage.log);
      crossing_pairs.find(stage.mesh);
      ASSERT_EQ(crossing_pairs.pairs().size(), stage.crossings());
      found += crossing_pairs.pairs().size();
    }
  }
  EXPECT_GT(found, 1000u);
}

TEST(CrossingPairs, UpdateEqualsFind) {
  int number = 0;
  for (const Mesh& model : embed_models()) {
    for (const BuildOptions& options : split_rules()) {
      SCOPED_TRACE(number++);
      if (check::kSanitized && number % 3 != 0) continue;
      EmbedStage stage(model, options);
      stage.make();
      CrossingPairs crossing_pairs(stage.view(), stage.loops, stage.log);
      crossing_pairs.find(stage.mesh);
      for (Index round = 0; round < 2; ++round) {
        crossing_pairs.update(stage.mesh, stage.refine_some(round, 17));
        ASSERT_EQ(crossing_pairs.pairs().size(), stage.crossings());
        CrossingPairs anew(stage.view(), stage.loops, stage.log);
        anew.find(stage.mesh);
        ASSERT_EQ(crossing_pairs.triangles(), anew.triangles());
      }
      check::expect_sound(stage.mesh);
    }
  }
}

// Several thousand tests, of which threads take parts.
TEST(CrossingPairs, ComeInOneOrderWithAnyNumberOfThreads) {
  EmbedStage stage(shapes::random_tetrahedra(12, 0),
                   {.strategy = SplitStrategy::kUniform, .depth = 12});
  stage.make();
  std::vector<std::pair<TriangleId, TriangleId>> with_one;
  for (const int threads : {1, 2, 3}) {
    const ThreadCount count(threads);
    CrossingPairs crossing_pairs(stage.view(), stage.loops, stage.log);
    crossing_pairs.find(stage.mesh);
    const std::vector pairs(crossing_pairs.pairs().begin(), crossing_pairs.pairs().end());
    ASSERT_GT(pairs.size(), 100u);
    if (threads == 1) with_one = pairs;
    EXPECT_EQ(pairs, with_one);
  }
}

// Looking at a mesh a second time, without changes, finds the same.
TEST(CrossingPairs, UpdateOfNothingChangesNothing) {
  EmbedStage stage(shapes::glass(0.02), {.strategy = SplitStrategy::kMedian, .depth = 13});
  stage.make();
  CrossingPairs crossing_pairs(stage.view(), stage.loops, stage.log);
  crossing_pairs.find(stage.mesh);
  const std::uint64_t pairs = crossing_pairs.pairs().size();
  const std::vector<TriangleId> triangles = crossing_pairs.triangles();
  ASSERT_GT(pairs, 0u);
  crossing_pairs.update(stage.mesh, {});
  EXPECT_EQ(crossing_pairs.pairs().size(), pairs);
  EXPECT_EQ(crossing_pairs.triangles(), triangles);
}

// A vertex is moved through the surface to its other side, many leaves away: the suspects round it
// cross triangles of leaves that are not theirs.
TEST(CrossingPairs, AreFoundAcrossLeaves) {
  EmbedStage stage(shapes::icosphere(4), {.relative_tolerance = 0.005});
  stage.make();
  CrossingPairs crossing_pairs(stage.view(), stage.loops, stage.log);
  crossing_pairs.find(stage.mesh);
  ASSERT_EQ(crossing_pairs.pairs().size(), 0u);
  const VertexId moved = 0;
  const Vec3 middle = Vec3::Constant(kLatticeSize / 2.0);
  const Vec3 before = stage.mesh.position[moved];
  stage.mesh.position[moved] = stage.rounded(middle - 1.2 * (before - middle));
  std::vector<HitId> changed;
  for (const HalfEdgeId h : stage.mesh.ring(moved)) changed.push_back(stage.mesh.hit[h / 3]);
  crossing_pairs.update(stage.mesh, changed);
  EXPECT_GT(crossing_pairs.pairs().size(), 0u);
  EXPECT_EQ(crossing_pairs.pairs().size(), stage.crossings());
  stage.mesh.position[moved] = before;
  crossing_pairs.update(stage.mesh, changed);
  EXPECT_EQ(crossing_pairs.pairs().size(), 0u);
  EXPECT_TRUE(crossing_pairs.triangles().empty());
}

// A triangle whose corners lie on one line is reported though it crosses nothing.
TEST(CrossingPairs, TrianglesWithoutAreaAreListed) {
  EmbedStage stage(shapes::icosphere(3), {.strategy = SplitStrategy::kUniform, .depth = 12});
  stage.make();
  const TriangleId flat = 0;
  const auto corner = [&](Index i) -> Vec3& {
    return stage.mesh.position[stage.mesh.vertex[3 * flat + i]];
  };
  corner(2) = corner(0);
  CrossingPairs crossing_pairs(stage.view(), stage.loops, stage.log);
  crossing_pairs.find(stage.mesh);
  const std::vector<TriangleId> triangles = crossing_pairs.triangles();
  EXPECT_TRUE(std::binary_search(triangles.begin(), triangles.end(), flat));
}

}  // namespace
}  // namespace kdm
