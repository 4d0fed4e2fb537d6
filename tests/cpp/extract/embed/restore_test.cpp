// SPDX-License-Identifier: MIT
// Parts of a mesh taken back.
#include "extract/embed/restore.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <vector>

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
      restore(stage.loops, stage.levels, all, stage.mesh, stage.log);
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
  const DualMesh before = stage.mesh;
  const Restored part = restore(stage.loops, stage.levels, {0}, stage.mesh, stage.log);
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
  stage.refine(&part);
  check::expect_sound(stage.mesh);
}

using Corners = std::array<std::array<double, 3>, 3>;

// The places of the corners of all triangles, in order.
std::vector<Corners> corners_of(const DualMesh& mesh) {
  std::vector<Corners> all;
  for (TriangleId t = 0; t < mesh.triangles(); ++t) {
    if (mesh.dropped(t)) continue;
    Corners corners;
    for (Index i = 0; i < 3; ++i) {
      const Vec3& p = mesh.position[mesh.vertex[3 * t + i]];
      corners[i] = {p[0], p[1], p[2]};
    }
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    all.push_back(corners);
  }
  std::sort(all.begin(), all.end());
  return all;
}

// What is put back and refined again at the same levels is what it was, and links that stay divided
// end the part.
TEST(Restore, IsDividedAgainAsItWas) {
  std::size_t stayed = 0;
  for (const Mesh& model : embed_models()) {
    for (const BuildOptions& options : split_rules()) {
      EmbedStage stage(model, options);
      for (Index h = 0; h < stage.grid.hits.size(); h += 2)
        stage.levels.hits[h] = EmbedLevel::kHitVertices;
      stage.refine();
      const std::vector<Corners> before = corners_of(stage.mesh);
      for (const Index first : {0, 7, 31}) {
        std::vector<HitId> asked;
        for (Index h = first; h < stage.grid.hits.size(); h += 60) asked.push_back(h);
        const Restored part = restore(stage.loops, stage.levels, asked, stage.mesh, stage.log);
        for (const OneSidedVertex& m : part.one_sided) {
          EXPECT_TRUE(std::binary_search(part.hits.begin(), part.hits.end(), m.half_edge / 3));
          EXPECT_FALSE(std::binary_search(part.hits.begin(), part.hits.end(), m.opposite / 3));
        }
        stayed += part.one_sided.size();
        stage.refine(&part);
        check::expect_sound(stage.mesh);
        EXPECT_EQ(corners_of(stage.mesh), before);
      }
      // Those on the other side of a link that stays may be divided in the same pass.
      std::vector<HitId> raised;
      for (Index h = 1; h < stage.grid.hits.size(); h += 20) raised.push_back(h);
      for (const HitId hit : raised) stage.levels.hits[hit] = EmbedLevel::kLinksApart;
      const Restored part = restore(stage.loops, stage.levels, raised, stage.mesh, stage.log);
      stage.refine(&part);
      check::expect_sound(stage.mesh);
    }
  }
  EXPECT_GT(stayed, 1000u);
}

}  // namespace
}  // namespace kdm
