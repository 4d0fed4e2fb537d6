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

namespace kdm {
namespace {

class Rounds {
 public:
  Rounds(const GridView& view, double margin, const EmbedSteps& steps, DualMesh& loops,
         DualMesh& mesh)
      : view_(view), steps_(steps), loops_(loops), mesh_(mesh) {
    levels_.hits.assign(view.grid.hits.size(), EmbedLevel::kTriangle);
    levels_.loops.assign(loops.vertices(), EmbedLevel::kTriangle);
    levels_.margin = margin;
    levels_.plain = &loops_;
    find_loops_of_leaves(view.grid, loops_);
  }

  Embedding run() {
    round_positions(loops_, 0);
    mesh_.position = loops_.position;
    steps_.make(levels_, nullptr, mesh_);
    round_positions(mesh_, loops_.vertices());
    Clashes clashes(view_, loops_);
    clashes.find(mesh_);
    int round = 0;
    for (;;) {
      const std::vector<Index> faulty = clashes.triangles();
      if (faulty.empty() || !add(faulty)) break;
      steps_.report(++round);
      clashes.find_again(mesh_, remake());
    }
    Embedding result;
    result.crossings = clashes.pairs();
    result.refined_hits = static_cast<Index>(
        std::count_if(levels_.hits.begin(), levels_.hits.end(),
                      [](EmbedLevel level) { return level != EmbedLevel::kTriangle; }));
    return result;
  }

 private:
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
      steps_.move(loops_, v, level);
      loops_.position[v] = rounded(loops_.position[v]);
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

  // Returns the hits whose triangles may have changed.
  std::vector<Index> remake() {
    mesh_.touched_hits.clear();
    const std::size_t vertices = mesh_.vertices();
    Restored part = restore(loops_, around_, mesh_);
    steps_.make(levels_, &part, mesh_);
    round_positions(mesh_, vertices);
    for (const Index v : part.loops) mesh_.position[v] = rounded(mesh_.position[v]);
    std::vector<Index> changed = std::move(part.hits);
    changed.insert(changed.end(), mesh_.touched_hits.begin(), mesh_.touched_hits.end());
    std::sort(changed.begin(), changed.end());
    changed.erase(std::unique(changed.begin(), changed.end()), changed.end());
    return changed;
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
  const EmbedSteps& steps_;
  DualMesh& loops_;
  DualMesh& mesh_;
  EmbedLevels levels_;
  std::vector<Index> around_;  // hits to be made again
};

}  // namespace

Embedding embed(const GridView& view, double margin, const EmbedSteps& steps, DualMesh& loops,
                DualMesh& mesh) {
  return Rounds(view, margin, steps, loops, mesh).run();
}

}  // namespace kdm
