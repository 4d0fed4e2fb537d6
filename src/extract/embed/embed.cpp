// SPDX-License-Identifier: MIT
// A result that does not meet itself.
//
// Fully refined, every hit is a vertex, every link one within its face, every loop one within its
// leaf, and each triangle (hit, link, loop) lies in one leaf: the surface in a leaf is the fan of
// an inner point over a closed curve on the leaf's sides. The idea goes back to T. Ju and T.
// Udeshi, Intersection-free contouring on an octree grid, 2006. That takes six triangles a hit, so
// it is done only where the plain mesh fails; each round raises the levels of some hits, and the
// highest level bounds them.
#include "extract/embed/embed.h"

#include <algorithm>

#include "extract/embed/clashes.h"
#include "extract/embed/layers.h"
#include "extract/embed/loop_position.h"
#include "extract/embed/restore.h"
#include "extract/mend/mend_edges.h"
#include "extract/place/add_vertices.h"
#include "mesh/progress.h"

namespace kdm {
namespace {

// A part of the tolerance, which no result shows.
constexpr double kSlightly = 1.0 / 32;

class Rounds {
 public:
  Rounds(const GridView& view, const FaceSettings& settings, DualMesh loops)
      : view_(view), settings_(settings), loops_(std::move(loops)) {
    levels_.hits.assign(view.grid.hits.size(), EmbedLevel::kTriangle);
    levels_.loops.assign(loops_.vertices(), EmbedLevel::kTriangle);
    levels_.margin = kSlightly * view.grid.tolerance;
    levels_.plain = &loops_;
    find_loops_of_leaves(view.grid, loops_);
  }

  Embedding run(std::span<const LoopId> missed, const Progress& progress) {
    place_loops();
    mesh_ = loops_;
    add_vertices(view_, settings_, levels_, missed, mesh_, log_);
    mend_edges(view_, settings_, levels_, mesh_, log_);
    round_positions(mesh_, loops_.vertices());
    Clashes clashes(view_, loops_, log_);
    clashes.find(mesh_);
    int round = 0;
    for (;;) {
      const std::vector<TriangleId> faulty = clashes.triangles();
      if (faulty.empty() || !add(faulty)) break;
      ++round;
      report_progress(progress, 0.9 - 0.2 / (1 + round), "faces");
      clashes.find_again(mesh_, remake());
    }
    const auto refined = std::count_if(levels_.hits.begin(), levels_.hits.end(),
                                       [](auto level) { return level != EmbedLevel::kTriangle; });
    return {std::move(mesh_), std::move(log_), static_cast<Index>(refined), clashes.pairs()};
  }

 private:
  // Inside of their leaves nearly all triangles are safe from each other. Vertices at rims stay
  // there, but at tips of corners beyond a leaf's side they do not.
  void place_loops() {
    const double margin = loops_.open ? 0 : kSlightly * view_.grid.tolerance;
    for (LoopId v = 0; v < loops_.vertices(); ++v) {
      loops_.position[v] = off_sides(view_.boxes[loops_.leaf[v]], margin, loops_.position[v]);
    }
    round_positions(loops_, 0);
  }

  // Raises the hits of these triangles and their loops by a level; false if all have the highest.
  bool add(const std::vector<Index>& triangles) {
    around_.clear();
    std::vector<Index> hits;
    std::vector<Index> crowded;
    for (const Index t : triangles) {
      if (levels_.hits[mesh_.hit[t]] < EmbedLevel::kCentred) {
        hits.push_back(mesh_.hit[t]);
      } else {
        find_crowded(t, crowded);
      }
    }
    std::sort(hits.begin(), hits.end());
    hits.erase(std::unique(hits.begin(), hits.end()), hits.end());
    for (const Index hit : hits) raise(hit, next_level(levels_.hits[hit]));
    for (const Index v : crowded) draw_inwards(v);
    return !around_.empty();
  }

  // Raises the hit and its loops to this level at least.
  void raise(Index hit, EmbedLevel level) {
    if (levels_.hits[hit] < level) {
      levels_.hits[hit] = level;
      around_.push_back(hit);
    }
    for (int i = 0; i < 3; ++i) {
      const Index v = loops_.vertex[3 * hit + i];
      if (levels_.loops[v] >= level) continue;
      levels_.loops[v] = level;
      loops_.position[v] = rounded(loop_position(view_, loops_, v, level));
      add_ring(v);
    }
  }

  // The loop that the triangle is round, if there are others in its leaf.
  void find_crowded(Index triangle, std::vector<Index>& crowded) const {
    for (Index h = 3 * triangle; h < 3 * triangle + 3; ++h) {
      const Index v = mesh_.vertex[h];
      if (v < loops_.vertices() && loops_.next_loop_in_leaf[v] != v) crowded.push_back(v);
    }
  }

  // Has this loop and the others of its leaf drawn inwards.
  void draw_inwards(Index v) {
    if (levels_.loops[v] == EmbedLevel::kNested) return;
    Index loop = v;
    do {
      for_each_hit(loop, [&](Index hit) { raise(hit, EmbedLevel::kCentred); });
      levels_.loops[loop] = EmbedLevel::kNested;
      add_ring(loop);
      loop = loops_.next_loop_in_leaf[loop];
    } while (loop != v);
  }

  void add_ring(Index v) {
    for_each_hit(v, [this](Index hit) { around_.push_back(hit); });
  }

  template <typename Visit>
  void for_each_hit(Index v, const Visit& visit) const {
    for (const HalfEdgeId h : loops_.ring(v)) visit(h / 3);
  }

  // Makes the part round the raised hits anew. Returns the hits whose triangles may have changed.
  std::vector<HitId> remake() {
    log_.forget_touched();
    const VertexId first_vertex = mesh_.vertices();
    const TriangleId first_triangle = mesh_.triangles();
    Restored part = restore(loops_, around_, mesh_, log_);
    add_vertices(view_, settings_, levels_, part.cut, mesh_, log_, part.hits);
    nest_loops(part.loops);
    mend_edges(view_, settings_, levels_, mesh_, log_,
               {part.hits, part.loops, first_vertex, first_triangle});
    round_positions(mesh_, first_vertex);
    for (const LoopId v : part.loops) mesh_.position[v] = rounded(mesh_.position[v]);
    std::vector<HitId> changed = std::move(part.hits);
    changed.insert(changed.end(), log_.touched_hits().begin(), log_.touched_hits().end());
    std::sort(changed.begin(), changed.end());
    changed.erase(std::unique(changed.begin(), changed.end()), changed.end());
    return changed;
  }

  // Draws those of the loops inwards that are at level kNested, leaf by leaf.
  void nest_loops(const std::vector<LoopId>& loops) {
    std::vector<std::pair<CellId, LoopId>> nested;
    for (const LoopId v : loops) {
      if (levels_.of_loop(v) == EmbedLevel::kNested) nested.emplace_back(mesh_.leaf[v], v);
    }
    std::sort(nested.begin(), nested.end());
    std::vector<LoopId> of_leaf;
    for (std::size_t i = 0; i < nested.size(); ++i) {
      const CellId leaf = nested[i].first;
      of_leaf.push_back(nested[i].second);
      if (i + 1 < nested.size() && nested[i + 1].first == leaf) continue;
      kdm::draw_inwards(view_.boxes[leaf], of_leaf, mesh_, log_);
      of_leaf.clear();
    }
  }

  void round_positions(DualMesh& mesh, std::size_t first) const {
    for (std::size_t v = first; v < mesh.position.size(); ++v) {
      mesh.position[v] = rounded(mesh.position[v]);
    }
  }

  Vec3 rounded(const Vec3& position) const {
    return view_.grid.lattice.to_lattice(single_precision(view_.grid.lattice, position));
  }

  static EmbedLevel next_level(EmbedLevel level) {
    return level == EmbedLevel::kCentred ? level
                                         : static_cast<EmbedLevel>(static_cast<int>(level) + 1);
  }

  GridView view_;
  const FaceSettings& settings_;
  DualMesh loops_;  // one triangle a hit
  DualMesh mesh_;   // made of the loops
  EditLog log_;     // of the mesh
  EmbedLevels levels_;
  std::vector<Index> around_;  // hits to be made again
};

}  // namespace

Embedding embed(const GridView& view, const FaceSettings& settings, std::span<const LoopId> missed,
                const Progress& progress, DualMesh loops) {
  return Rounds(view, settings, std::move(loops)).run(missed, progress);
}

}  // namespace kdm
