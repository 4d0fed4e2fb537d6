// SPDX-License-Identifier: MIT
// Triangles that are there again after parts of a mesh were made anew.
#include "extract/embed/remade_triangles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <stdexcept>

#include "support/embed_stage.h"

namespace kdm {
namespace {

using check::EmbedStage;

// A mesh of which every 17th hit is refined, and what is remembered of it.
struct Remembered {
  Remembered()
      : stage(shapes::icosphere(4), {.relative_tolerance = 0.005}),
        triangles(static_cast<Index>(stage.grid.hits.size())),
        remade(static_cast<Index>(stage.grid.hits.size())) {
    stage.make();
    stage.refine_some(0, 17);
    compare(stage.all_hits());
  }

  void compare(const std::vector<HitId>& hits) {
    triangles.update(stage.mesh, hits);
    remade.compare(stage.mesh, triangles, hits);
  }

  EmbedStage stage;
  HitTriangles triangles;
  RemadeTriangles remade;
};

std::vector<TriangleId> list_of(const HitTriangles& triangles, const DualMesh& mesh, HitId hit) {
  std::vector<TriangleId> list;
  triangles.for_each(hit, [&](TriangleId t) {
    list.push_back(t);
    if (list.size() > mesh.triangles()) throw std::length_error("a list has no end");
  });
  return list;
}

// The lists must be those that would be made of the mesh as it is.
void expect_right_lists(const Remembered& all) {
  HitTriangles anew(static_cast<Index>(all.stage.grid.hits.size()));
  anew.update(all.stage.mesh, all.stage.all_hits());
  for (const HitId hit : all.stage.all_hits()) {
    ASSERT_EQ(list_of(all.triangles, all.stage.mesh, hit), list_of(anew, all.stage.mesh, hit))
        << hit;
  }
}

TEST(HitTriangles, AreUpToDateOnceChangedHitsAreNamed) {
  Remembered all;
  for (Index round = 0; round < 3; ++round) {
    const std::vector<HitId> changed = all.stage.refine_some(round, 17 + round);
    all.triangles.update(all.stage.mesh, changed);
    expect_right_lists(all);
  }
}

// A flip may give the first triangle of a hit to another hit, whose list stays as it is when the
// hit is named again.
TEST(HitTriangles, KnowATriangleThatWasGivenAway) {
  Remembered all;
  DualMesh& mesh = all.stage.mesh;
  mesh.hit[5] = 6;
  all.triangles.update(mesh, std::vector<HitId>{5, 6});
  expect_right_lists(all);
  all.triangles.update(mesh, std::vector<HitId>{5});
  expect_right_lists(all);
}

TEST(RemadeTriangles, NothingIsAsBeforeAtFirst) {
  const Remembered all;
  for (const HitId hit : all.stage.all_hits()) ASSERT_FALSE(all.remade.as_before(hit));
}

TEST(RemadeTriangles, AreFoundUnderTheirNewNumbers) {
  Remembered all;
  const DualMesh before = all.stage.mesh;
  // The hits have their levels already, so most triangles are made again. Mending goes over more
  // edges than before, and flips some.
  const std::vector<HitId> hits = all.stage.refine_some(0, 17);
  all.compare(hits);
  const auto as_before =
      std::count_if(hits.begin(), hits.end(), [&](HitId hit) { return all.remade.as_before(hit); });
  ASSERT_GT(as_before, static_cast<std::ptrdiff_t>(hits.size() / 2));
  const DualMesh& mesh = all.stage.mesh;
  std::size_t moved = 0;
  std::map<VertexId, VertexId> now;
  for (TriangleId t = 0; t < before.triangles(); ++t) {
    if (before.dropped(t)) continue;
    const TriangleId there = all.remade.now(t);
    if (there == kNone) {
      EXPECT_FALSE(all.remade.as_before(before.hit[t]));
      continue;
    }
    moved += there != t ? 1 : 0;
    for (Index k = 0; k < 3; ++k) {
      const VertexId v = before.vertex[3 * t + k];
      const VertexId w = mesh.vertex[3 * there + k];
      EXPECT_EQ(before.position[v], mesh.position[w]);
      EXPECT_EQ(now.try_emplace(v, w).first->second, w);
    }
  }
  EXPECT_GT(moved, 100u);
}

TEST(RemadeTriangles, AreOthersRoundAVertexThatHasMoved) {
  Remembered all;
  DualMesh& mesh = all.stage.mesh;
  const VertexId moved = 5;
  std::vector<HitId> round_it;
  for (const HalfEdgeId h : mesh.ring(moved)) round_it.push_back(mesh.hit[h / 3]);
  mesh.position[moved] += Vec3::Constant(kLatticeSize / 64.0);
  all.compare(all.stage.all_hits());
  std::size_t as_before = 0;
  for (const HitId hit : all.stage.all_hits()) {
    const bool is_round_it = std::find(round_it.begin(), round_it.end(), hit) != round_it.end();
    EXPECT_NE(all.remade.as_before(hit), is_round_it);
    as_before += all.remade.as_before(hit) ? 1 : 0;
  }
  EXPECT_GT(as_before, 10 * round_it.size());
  for (const HalfEdgeId h : mesh.ring(moved)) EXPECT_EQ(all.remade.now(h / 3), kNone);
}

// Where two vertices are at one place, triangles that have changed from one to the other have
// nothing in common any more with those that have not.
TEST(RemadeTriangles, AreOthersAtAnotherVertexOfTheSamePlace) {
  Remembered all;
  DualMesh& mesh = all.stage.mesh;
  const VertexId split = 5;
  const HalfEdgeId one = mesh.first_half_edge[split];
  const HitId hit = mesh.hit[one / 3];
  const VertexId twin = mesh.vertices();
  mesh.position.push_back(mesh.position[split]);
  mesh.leaf.push_back(kNone);
  mesh.first_half_edge.push_back(one);
  mesh.vertex[one] = twin;
  mesh.first_half_edge[split] = mesh.next_in_ring(one);
  all.compare(all.stage.all_hits());
  for (const HitId other : all.stage.all_hits()) {
    EXPECT_EQ(all.remade.as_before(other), other != hit) << other;
  }
}

}  // namespace
}  // namespace kdm
