// SPDX-License-Identifier: MIT
// Clashes found by way of envelopes, against all pairs of triangles.
#include "extract/embed/clashes.h"

#include <gtest/gtest.h>

#include "extract/embed/restore.h"
#include "extract/emit.h"
#include "extract/mend/double_edges.h"
#include "extract/mend/unfold.h"
#include "extract/place/place.h"
#include "extract/place/refine.h"
#include "kdmanifold/build.h"
#include "support/dual_mesh_check.h"
#include "support/random_meshes.h"
#include "support/shapes.h"

namespace kdm {
namespace {

// What `extract` has before it looks for clashes.
struct Stage {
  explicit Stage(const Mesh& input, const BuildOptions& options)
      : handle(build_grid(input, options)),
        grid(handle.data()),
        boxes(cell_boxes(grid)),
        points(hit_points(grid, boxes)),
        loops(dual_mesh_of(grid)) {
    drop_pillows(loops);
    find_loops(grid, loops);
    place_vertices(view(), {}, loops);
    for (Index v = 0; v < loops.position.size(); ++v) {
      const Vec3 lo = to_vec3(boxes[loops.leaf[v]].lo);
      const Vec3 hi = to_vec3(boxes[loops.leaf[v]].hi);
      const Vec3 margin = (hi - lo) / 64;
      loops.position[v] = rounded(loops.position[v].cwiseMax(lo + margin).cwiseMin(hi - margin));
    }
    mesh = loops;
    levels.hits.assign(grid.hits.size(), EmbedLevel::kTriangle);
    levels.loops.assign(loops.vertices(), EmbedLevel::kTriangle);
  }

  void make(const Scope& hits = {}) {
    const std::size_t vertices = mesh.vertices();
    refine(view(), levels, grid.tolerance, mesh, log, hits);
    std::vector<Index> present;
    for (Index v = 0; v < mesh.vertices(); ++v) {
      if (mesh.first_half_edge[v] != kNone) present.push_back(v);
    }
    separate_double_edges(view(), mesh, log, present);
    unfold(view(), levels, mesh, log);
    for (std::size_t v = vertices; v < mesh.position.size(); ++v) {
      mesh.position[v] = rounded(mesh.position[v]);
    }
  }

  GridView view() const { return {grid, boxes, points}; }

  Vec3 rounded(const Vec3& p) const {
    return grid.lattice.to_lattice(single_precision(grid.lattice, p));
  }

  std::uint64_t crossings() const {
    return find_self_intersections(emit(grid, mesh, {}, false, true)).pairs;
  }

  Grid handle;
  const GridData& grid;
  std::vector<LatticeBox> boxes;
  std::vector<Vec3> points;
  DualMesh loops;
  DualMesh mesh;
  EditLog log;
  EmbedLevels levels;
};

std::vector<Mesh> models() {
  std::vector<Mesh> models = {
      shapes::rotated(shapes::stairs(4), Vec3(1, 2, 3), 0.7),
      shapes::rotated(shapes::plate_with_holes(2, 2), Vec3(3, 1, 2), 1),
      shapes::glass(0.02),
      shapes::swiss_cheese(5),
      shapes::torus_chain(2),
      shapes::icosphere(3),
      shapes::rotated(shapes::thin_walled_box(1.0 / 50), Vec3(1, 1, 3), 0.4)};
  for (std::uint32_t seed = 0; seed < 2; ++seed) {
    models.push_back(shapes::random_tetrahedra(12, seed));
    models.push_back(shapes::random_voxels(3, 0.4, seed));
  }
  return models;
}

std::vector<BuildOptions> rules() {
  return {{.relative_tolerance = 0.005},
          {.strategy = SplitStrategy::kOctree, .depth = 12},
          {.strategy = SplitStrategy::kMedian, .depth = 13},
          {.strategy = SplitStrategy::kUniform, .depth = 12}};
}

TEST(Clashes, AreThoseOfAllPairs) {
  std::uint64_t found = 0;
  int number = 0;
  for (const Mesh& model : models()) {
    for (const BuildOptions& options : rules()) {
      SCOPED_TRACE(number++);
      Stage stage(model, options);
      stage.make();
      Clashes clashes(stage.view(), stage.loops, stage.log);
      clashes.find(stage.mesh);
      ASSERT_EQ(clashes.pairs(), stage.crossings());
      found += clashes.pairs();
    }
  }
  EXPECT_GT(found, 1000u);
}

// Most of a smooth surface needs no pairs looked at: that is what envelopes are for.
TEST(Clashes, MostHitsKeepToTheirEnvelopes) {
  for (const BuildOptions& options : rules()) {
    Stage stage(shapes::icosphere(4), options);
    stage.make();
    Envelopes envelopes(stage.view(), stage.loops, stage.log);
    HitTriangles triangles(static_cast<Index>(stage.grid.hits.size()));
    triangles.read(stage.mesh);
    std::size_t held = 0;
    for (Index hit = 0; hit < stage.grid.hits.size(); ++hit) {
      held += envelopes.holds(stage.mesh, triangles, hit) ? 1 : 0;
    }
    EXPECT_GT(held, stage.grid.hits.size() * 6 / 10);
  }
}

TEST(Clashes, AreTheSameAfterChanges) {
  int number = 0;
  for (const Mesh& model : models()) {
    for (const BuildOptions& options : rules()) {
      SCOPED_TRACE(number++);
      Stage stage(model, options);
      stage.make();
      Clashes clashes(stage.view(), stage.loops, stage.log);
      clashes.find(stage.mesh);
      for (Index round = 0; round < 2; ++round) {
        std::vector<Index> hits;
        for (Index h = round; h < stage.grid.hits.size(); h += 17) {
          if (stage.loops.dropped(h)) continue;
          stage.levels.hits[h] = EmbedLevel::kHitVertices;
          hits.push_back(h);
        }
        stage.log.forget_touched();
        Restored part = restore(stage.loops, hits, stage.mesh, stage.log);
        stage.make(part.hits);
        part.hits.insert(part.hits.end(), stage.log.touched_hits().begin(),
                         stage.log.touched_hits().end());
        clashes.find_again(stage.mesh, part.hits);
        ASSERT_EQ(clashes.pairs(), stage.crossings());
      }
      check::expect_sound(stage.mesh);
    }
  }
}

TEST(Restore, TakesEverythingBack) {
  for (const Mesh& model : models()) {
    for (const BuildOptions& options : rules()) {
      Stage stage(model, options);
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
  Stage stage(shapes::rotated(shapes::stairs(4), Vec3(1, 2, 3), 0.7),
              {.relative_tolerance = 0.005});
  for (Index h = 0; h < stage.grid.hits.size(); h += 40)
    stage.levels.hits[h] = EmbedLevel::kHitVertices;
  stage.make();
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
