// SPDX-License-Identifier: MIT
// The state of a mesh in the midst of embedding, for tests of its parts.
#pragma once

#include <cstdint>
#include <vector>

#include "extract/dual/edit_log.h"
#include "extract/dual/embed_level.h"
#include "extract/dual/grid_view.h"
#include "extract/embed/restore.h"
#include "extract/emit.h"
#include "extract/mend/double_edges.h"
#include "extract/mend/unfold.h"
#include "extract/place/place.h"
#include "extract/place/refine.h"
#include "kdmanifold/analyze.h"
#include "kdmanifold/build.h"
#include "support/random_meshes.h"
#include "support/shapes.h"

namespace kdm::check {

/// A grid, the mesh of one triangle a hit that is made of it, and a mesh made from that, as `embed`
/// has them before it looks for crossings.
struct EmbedStage {
  EmbedStage(const Mesh& input, const BuildOptions& options)
      : handle(build_grid(input, options)),
        grid(handle.data()),
        boxes(cell_boxes(grid)),
        points(hit_points(grid, boxes)),
        loops(dual_mesh_of(grid)) {
    drop_pillows(loops);
    find_loops(grid, loops);
    find_loops_of_leaves(grid, loops);
    place_vertices(view(), {}, loops);
    for (VertexId v = 0; v < loops.position.size(); ++v) {
      const Vec3 lo = to_vec3(boxes[loops.leaf[v]].lo);
      const Vec3 hi = to_vec3(boxes[loops.leaf[v]].hi);
      const Vec3 margin = (hi - lo) / 64;
      loops.position[v] = rounded(loops.position[v].cwiseMax(lo + margin).cwiseMin(hi - margin));
    }
    mesh = loops;
    levels.hits.assign(grid.hits.size(), EmbedLevel::kTriangle);
    levels.loops.assign(loops.vertices(), EmbedLevel::kTriangle);
  }

  /// Refines the mesh as the levels say: all of it, or a part that was put back.
  void refine(const Restored* part = nullptr) {
    const std::size_t vertices = mesh.vertices();
    if (part == nullptr) {
      kdm::refine(view(), levels, grid.tolerance, mesh, log);
    } else {
      kdm::refine(view(), levels, grid.tolerance, mesh, log, part->hits, part->one_sided);
    }
    round_from(vertices);
  }

  /// Does the same and mends the mesh.
  void make(const Restored* part = nullptr) {
    const std::size_t vertices = mesh.vertices();
    refine(part);
    std::vector<VertexId> present;
    for (VertexId v = 0; v < mesh.vertices(); ++v) {
      if (mesh.first_half_edge[v] != kNone) present.push_back(v);
    }
    separate_double_edges(view(), mesh, log, present);
    unfold(view(), levels, mesh, log);
    round_from(vertices);
  }

  /// Makes every `step`-th hit from `first` on anew, with vertices at the hit and its links.
  /// Returns the hits whose triangles may have changed, as `embed` does in each of its rounds.
  std::vector<HitId> refine_some(HitId first, Index step) {
    std::vector<HitId> hits;
    for (HitId h = first; h < grid.hits.size(); h += step) {
      if (loops.dropped(h)) continue;
      levels.hits[h] = EmbedLevel::kHitVertices;
      hits.push_back(h);
    }
    log.forget_touched();
    Restored part = restore(loops, levels, hits, mesh, log);
    make(&part);
    part.hits.insert(part.hits.end(), log.touched_hits().begin(), log.touched_hits().end());
    return std::move(part.hits);
  }

  std::vector<HitId> all_hits() const {
    std::vector<HitId> hits;
    for (HitId hit = 0; hit < grid.hits.size(); ++hit) hits.push_back(hit);
    return hits;
  }

  GridView view() const { return {grid, boxes, points}; }

  /// Rounds the places of this vertex and all after it to 32 bits.
  void round_from(std::size_t vertex) {
    for (std::size_t v = vertex; v < mesh.position.size(); ++v) {
      mesh.position[v] = rounded(mesh.position[v]);
    }
  }

  Vec3 rounded(const Vec3& p) const {
    return grid.lattice.to_lattice(single_precision(grid.lattice, p));
  }

  /// Counts the pairs of triangles that cross or touch, by looking at all of them.
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

/// Models that are hard to embed, and easy ones.
inline std::vector<Mesh> embed_models() {
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

/// One set of options for each way to split cells.
inline std::vector<BuildOptions> split_rules() {
  return {{.relative_tolerance = 0.005},
          {.strategy = SplitStrategy::kOctree, .depth = 12},
          {.strategy = SplitStrategy::kMedian, .depth = 13},
          {.strategy = SplitStrategy::kUniform, .depth = 12}};
}

}  // namespace kdm::check
