// SPDX-License-Identifier: MIT
// Which hits keep to their envelopes, and which triangles are suspects.
#include "extract/embed/suspects.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/embed_stage.h"

namespace kdm {
namespace {

using check::embed_models;
using check::EmbedStage;
using check::split_rules;

// Most of a smooth surface needs no pairs looked at: that is what envelopes are for.
TEST(Envelopes, MostHitsKeepToTheirEnvelopes) {
  for (const BuildOptions& options : split_rules()) {
    EmbedStage stage(shapes::icosphere(4), options);
    stage.make();
    Envelopes envelopes(stage.view(), stage.loops, stage.log);
    HitTriangles triangles(static_cast<Index>(stage.grid.hits.size()));
    triangles.update(stage.mesh, stage.all_hits());
    std::size_t enclosed = 0;
    for (HitId hit = 0; hit < stage.grid.hits.size(); ++hit) {
      enclosed += envelopes.enclose(stage.mesh, triangles, hit) ? 1 : 0;
    }
    EXPECT_GT(enclosed, stage.grid.hits.size() * 6 / 10);
  }
}

// A vertex is drawn through the surface so far that the triangles round it are folded over their
// neighbours: they are suspects, and hits that have nothing to do with them stay enclosed.
TEST(Suspects, AreTheFoldedTriangles) {
  EmbedStage stage(shapes::icosphere(4), {.relative_tolerance = 0.005});
  stage.make();
  Suspects suspects(stage.view(), stage.loops, stage.log);
  suspects.update(stage.mesh, stage.all_hits());
  // An enclosed hit of which no corner is shared with a hit that is not.
  const auto ring_is_enclosed = [&](VertexId v) {
    for (const HalfEdgeId h : stage.mesh.ring(v)) {
      if (!suspects.is_enclosed(stage.mesh.hit[h / 3])) return false;
    }
    return true;
  };
  VertexId moved = 0;
  while (moved < stage.loops.vertices() && !ring_is_enclosed(moved)) ++moved;
  ASSERT_LT(moved, stage.loops.vertices());
  std::vector<bool> before;
  for (HitId hit = 0; hit < stage.grid.hits.size(); ++hit) {
    before.push_back(suspects.is_enclosed(hit));
  }
  stage.mesh.position[moved] += Vec3::Constant(kLatticeSize / 4.0);
  std::vector<HitId> changed;
  for (const HalfEdgeId h : stage.mesh.ring(moved)) changed.push_back(stage.mesh.hit[h / 3]);
  const std::vector<HitId> updated = suspects.update(stage.mesh, changed);
  for (const HitId hit : changed) {
    EXPECT_TRUE(std::binary_search(updated.begin(), updated.end(), hit));
    EXPECT_FALSE(suspects.is_enclosed(hit));
  }
  for (HitId hit = 0; hit < stage.grid.hits.size(); ++hit) {
    if (std::binary_search(updated.begin(), updated.end(), hit)) continue;
    EXPECT_EQ(suspects.is_enclosed(hit), before[hit]);
  }
}

// After changes to some hits, all hits are as they are found anew.
TEST(Suspects, UpdateEqualsFindingAnew) {
  int number = 0;
  for (const Mesh& model : embed_models()) {
    SCOPED_TRACE(number++);
    EmbedStage stage(model, {.strategy = SplitStrategy::kMedian, .depth = 13});
    stage.make();
    Suspects suspects(stage.view(), stage.loops, stage.log);
    suspects.update(stage.mesh, stage.all_hits());
    suspects.update(stage.mesh, stage.refine_some(0, 23));
    Suspects anew(stage.view(), stage.loops, stage.log);
    anew.update(stage.mesh, stage.all_hits());
    for (HitId h = 0; h < stage.grid.hits.size(); ++h) {
      ASSERT_EQ(suspects.is_enclosed(h), anew.is_enclosed(h)) << "hit " << h;
    }
  }
}

}  // namespace
}  // namespace kdm
