// SPDX-License-Identifier: MIT
// Parts of a mesh taken back.
#include "extract/embed/restore.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/dual_mesh_check.h"
#include "support/embed_stage.h"

namespace kdm {
namespace {

using check::embed_models;
using check::EmbedStage;
using check::split_rules;

TEST(Restore, TakesEverythingBack) {
  for (const Mesh& model : embed_models()) {
    for (const BuildOptions& options : split_rules()) {
      EmbedStage stage(model, options);
      for (Index h = 0; h < stage.grid.hits.size(); h += 5)
        stage.levels.hits[h] = EmbedLevel::kHitVertices;
      stage.make();
      std::vector<Index> all;
      for (Index h = 0; h < stage.grid.hits.size(); ++h) all.push_back(h);
      restore(stage.loops, all, stage.mesh, stage.log);
      const std::size_t half_edges = stage.loops.vertex.size();
      for (std::size_t h = 0; h < half_edges; ++h) {
        ASSERT_EQ(stage.mesh.vertex[h], stage.loops.vertex[h]);
        if (stage.loops.vertex[h] == kNone) continue;
        ASSERT_EQ(stage.mesh.opposite[h], stage.loops.opposite[h]);
      }
      for (Index t = stage.loops.triangles(); t < stage.mesh.triangles(); ++t) {
        ASSERT_TRUE(stage.mesh.dropped(t));
      }
      for (std::size_t v = stage.loops.vertices(); v < stage.mesh.vertices(); ++v) {
        ASSERT_EQ(stage.mesh.first_half_edge[v], kNone);
      }
    }
  }
}

// Beyond what is tied to the hits nothing changes.
TEST(Restore, LeavesTheRest) {
  EmbedStage stage(shapes::rotated(shapes::stairs(4), Vec3(1, 2, 3), 0.7),
                   {.relative_tolerance = 0.005});
  for (Index h = 0; h < stage.grid.hits.size(); h += 40)
    stage.levels.hits[h] = EmbedLevel::kHitVertices;
  stage.make();
  // Leaves that hold several loops would tie 155 of the 176 hits of this small grid together.
  stage.loops.next_loop_in_leaf.clear();
  const DualMesh before = stage.mesh;
  const Restored part = restore(stage.loops, {0}, stage.mesh, stage.log);
  ASSERT_LT(part.hits.size(), stage.grid.hits.size() / 2);
  EXPECT_TRUE(std::is_sorted(part.hits.begin(), part.hits.end()));
  std::size_t kept = 0;
  for (Index t = 0; t < before.triangles(); ++t) {
    if (before.dropped(t) ||
        std::binary_search(part.hits.begin(), part.hits.end(), before.hit[t])) {
      continue;
    }
    for (Index i = 0; i < 3; ++i) EXPECT_EQ(stage.mesh.vertex[3 * t + i], before.vertex[3 * t + i]);
    ++kept;
  }
  EXPECT_GT(kept, before.triangles() / 2);
  check::expect_sound(stage.mesh);
}

}  // namespace
}  // namespace kdm
