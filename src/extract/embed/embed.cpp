// SPDX-License-Identifier: MIT
// Looks for crossings and refines the hits concerned, round after round.
//
// At the highest levels every hit has a vertex on its edge, every link one within its minimal face,
// every loop one within its leaf. Then each triangle joins a hit, a link and a loop and lies in one
// leaf, and the surface in a leaf is the fan of a point inside of the leaf over a closed curve on
// the leaf's sides, which does not meet itself. The idea goes back to T. Ju and T. Udeshi,
// Intersection-free contouring on an octree grid, 2006. But that takes six triangles a hit. So hits
// are refined only where the plain mesh fails: each round raises the levels of some, and as there
// is a highest level, the rounds end.
#include "extract/embed/embed.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "extract/embed/crossing_pairs.h"
#include "extract/embed/loop_position.h"
#include "extract/embed/nested_loops.h"
#include "extract/embed/part_contacts.h"
#include "extract/embed/restore.h"
#include "extract/mend/mend_edges.h"
#include "extract/place/add_vertices.h"
#include "mesh/progress.h"
#include "mesh/sort.h"

namespace kdm {
namespace {

// The most that vertices keep off sides, as a fraction of the tolerance: too little to be seen in a
// result.
constexpr double kMaxMargin = 1.0 / 32;
// How far vertices move at a time where parts touch, and how far in all, as fractions of the
// tolerance.
constexpr double kParting = 1.0 / 16;
constexpr double kMostParting = 1.0 / 4;
constexpr int kMostPartings = 2;  // between two rounds

class Rounds {
 public:
  Rounds(const GridView& view, const FaceSettings& settings, DualMesh loops)
      : view_(view), settings_(settings), loops_(std::move(loops)) {
    levels_.hits.assign(view.grid.hits.size(), EmbedLevel::kTriangle);
    levels_.loops.assign(loops_.vertices(), EmbedLevel::kTriangle);
    levels_.margin = kMaxMargin * view.grid.tolerance;
    levels_.plain = &loops_;
    find_loops_of_leaves(view.grid, loops_);
  }

  Embedding run(std::span<const LoopId> missed, const Progress& progress) {
    move_loops_off_sides();
    make_whole_mesh(missed);
    CrossingPairs crossing_pairs(view_, loops_, log_);
    crossing_pairs.find(mesh_);
    double opened = 0;  // how far vertices at contacts have moved
    for (int round = 1;; ++round) {
      for (int i = 0; i < kMostPartings && !crossing_pairs.pairs().empty(); ++i) {
        const std::vector<HitId> changed = part_pairs(crossing_pairs, opened);
        if (changed.empty()) break;
        crossing_pairs.update(mesh_, changed);
      }
      hits_to_remake_.clear();
      raise_levels(crossing_pairs.triangles());
      if (hits_to_remake_.empty()) break;
      report_progress(progress, 0.9 - 0.2 / (1 + round), "faces");
      crossing_pairs.update(mesh_, remake_part());
    }
    const auto refined = std::count_if(levels_.hits.begin(), levels_.hits.end(),
                                       [](auto level) { return level != EmbedLevel::kTriangle; });
    return {std::move(mesh_), std::move(log_), static_cast<Index>(refined),
            crossing_pairs.pairs().size()};
  }

 private:
  // Moves the loops' vertices a little off the sides of their leaves: nearly all triangles are then
  // safe from each other. In an open mesh only moves them into their leaves, so that vertices at
  // rims stay where they are.
  void move_loops_off_sides() {
    const double margin = loops_.open ? 0 : kMaxMargin * view_.grid.tolerance;
    for (LoopId v = 0; v < loops_.vertices(); ++v) {
      loops_.position[v] =
          rounded(off_sides(view_.boxes[loops_.leaf[v]], margin, loops_.position[v]));
    }
  }

  void make_whole_mesh(std::span<const LoopId> missed) {
    mesh_ = loops_;
    add_vertices(view_, settings_, levels_, missed, mesh_, log_);
    mend_edges(view_, settings_, levels_, mesh_, log_);
    round_positions_from(loops_.vertices());
  }

  // Moves vertices at contacts apart, by up to a quarter of the tolerance in all. Returns the hits
  // whose triangles have changed; ascending.
  std::vector<HitId> part_pairs(const CrossingPairs& crossing_pairs, double& opened) {
    const double tolerance = view_.grid.tolerance;
    const double step = std::max(2.0, kParting * tolerance);
    std::vector<HitId> changed;
    if (opened + step > kMostParting * tolerance && opened > 0) return changed;
    opened += step;
    for (const VertexId v : part_contacts(crossing_pairs.pairs(), step, step, mesh_)) {
      mesh_.position[v] = rounded(mesh_.position[v]);
      if (v < loops_.vertices()) loops_.position[v] = mesh_.position[v];
      for (const HalfEdgeId h : mesh_.ring(v)) changed.push_back(mesh_.hit[h / 3]);
    }
    make_set(changed);
    return changed;
  }

  // Raises the hits of these triangles by a level; the loops round which triangles of the highest
  // level are become nested. Lists the hits that are to be made anew in `hits_to_remake_`: none if
  // nothing can be raised any more.
  void raise_levels(const std::vector<TriangleId>& faulty) {
    std::vector<HitId> hits;
    std::vector<LoopId> loops_to_nest;
    for (const TriangleId t : faulty) {
      if (levels_.hits[mesh_.hit[t]] < EmbedLevel::kCentred) {
        hits.push_back(mesh_.hit[t]);
      } else {
        find_loops_with_neighbours(t, loops_to_nest);
      }
    }
    make_set(hits);
    for (const HitId hit : hits) raise(hit, next_level(levels_.hits[hit]));
    for (const LoopId v : loops_to_nest) raise_to_nested(v);
  }

  static EmbedLevel next_level(EmbedLevel level) {
    return static_cast<EmbedLevel>(static_cast<int>(level) + 1);
  }

  // Raises the hit and its loops to this level at least.
  void raise(HitId hit, EmbedLevel level) {
    if (levels_.hits[hit] < level) {
      levels_.hits[hit] = level;
      hits_to_remake_.push_back(hit);
    }
    for (HalfEdgeId h = 3 * hit; h < 3 * hit + 3; ++h) {
      const LoopId v = loops_.vertex[h];
      if (levels_.loops[v] >= level) continue;
      levels_.loops[v] = level;
      loops_.position[v] = rounded(loop_position(view_, loops_, v, level));
      remake_hits_round(v);
    }
  }

  // Appends the loops at corners of the triangle that are not alone in their leaves.
  void find_loops_with_neighbours(TriangleId t, std::vector<LoopId>& loops) const {
    for (HalfEdgeId h = 3 * t; h < 3 * t + 3; ++h) {
      const VertexId v = mesh_.vertex[h];
      if (v < loops_.vertices() && loops_.next_loop_in_leaf[v] != v) loops.push_back(v);
    }
  }

  // Raises all loops of this loop's leaf to level `kNested`.
  void raise_to_nested(LoopId v) {
    if (levels_.loops[v] == EmbedLevel::kNested) return;
    LoopId loop = v;
    do {
      for (const HalfEdgeId h : loops_.ring(loop)) raise(h / 3, EmbedLevel::kCentred);
      levels_.loops[loop] = EmbedLevel::kNested;
      remake_hits_round(loop);
      loop = loops_.next_loop_in_leaf[loop];
    } while (loop != v);
  }

  void remake_hits_round(LoopId v) {
    for (const HalfEdgeId h : loops_.ring(v)) hits_to_remake_.push_back(h / 3);
  }

  // Takes back what was done to the hits to remake and to all that is tied to them, and makes that
  // part anew at the present levels. Returns, ascending, all hits whose triangles may have changed.
  std::vector<HitId> remake_part() {
    log_.forget_touched();
    const VertexId first_vertex = mesh_.vertices();
    const TriangleId first_triangle = mesh_.triangles();
    Restored part = restore(loops_, hits_to_remake_, mesh_, log_);
    add_vertices(view_, settings_, levels_, part.split, mesh_, log_, part.hits);
    nest_loops_of_leaves(part.loops);
    mend_edges(view_, settings_, levels_, mesh_, log_,
               {part.hits, part.loops, first_vertex, first_triangle});
    round_positions_from(first_vertex);
    for (const LoopId v : part.loops) mesh_.position[v] = rounded(mesh_.position[v]);
    std::vector<HitId> changed = std::move(part.hits);
    changed.insert(changed.end(), log_.touched_hits().begin(), log_.touched_hits().end());
    make_set(changed);
    return changed;
  }

  // Nests the loops among these that are at level `kNested`, leaf by leaf. Where that cannot be
  // done, the triangles stay as they are and may cross.
  void nest_loops_of_leaves(const std::vector<LoopId>& loops) {
    std::vector<std::pair<CellId, LoopId>> nested;
    for (const LoopId v : loops) {
      if (levels_.of_loop(v) == EmbedLevel::kNested) nested.emplace_back(mesh_.leaf[v], v);
    }
    sort_up(nested);
    std::vector<LoopId> loops_of_leaf;
    for (std::size_t i = 0; i < nested.size(); ++i) {
      const CellId leaf = nested[i].first;
      loops_of_leaf.push_back(nested[i].second);
      if (i + 1 < nested.size() && nested[i + 1].first == leaf) continue;
      nest_loops(view_.boxes[leaf], loops_of_leaf, mesh_, log_);
      loops_of_leaf.clear();
    }
  }

  void round_positions_from(VertexId first) {
    for (VertexId v = first; v < mesh_.vertices(); ++v) {
      mesh_.position[v] = rounded(mesh_.position[v]);
    }
  }

  // Returns the nearest point, in lattice units, whose model coordinates are 32-bit floats.
  Vec3 rounded(const Vec3& position) const {
    return view_.grid.lattice.to_lattice(single_precision(view_.grid.lattice, position));
  }

  GridView view_;
  const FaceSettings& settings_;
  DualMesh loops_;  // one triangle a hit; its vertices move as levels rise
  DualMesh mesh_;   // made from `loops_`
  EditLog log_;     // what was done to `mesh_`
  EmbedLevels levels_;
  std::vector<HitId> hits_to_remake_;  // in the present round, some of them several times
};

}  // namespace

Embedding embed(const GridView& view, const FaceSettings& settings, std::span<const LoopId> missed,
                const Progress& progress, DualMesh loops) {
  return Rounds(view, settings, std::move(loops)).run(missed, progress);
}

}  // namespace kdm
