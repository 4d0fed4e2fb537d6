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
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "extract/dual/clearance.h"
#include "extract/embed/crossing_pairs.h"
#include "extract/embed/loop_position.h"
#include "extract/embed/move_back.h"
#include "extract/embed/nested_loops.h"
#include "extract/embed/part_contacts.h"
#include "extract/embed/restore.h"
#include "extract/mend/mend_edges.h"
#include "extract/place/add_vertices.h"
#include "mesh/marks.h"
#include "mesh/progress.h"
#include "mesh/sort.h"

namespace kdm {
namespace {

// The most that vertices keep off sides, as a fraction of the tolerance: too little to be seen in a
// result.
constexpr double kMaxMargin = 1.0 / 32;
// A vertex no further than this from a plane lies on it; as a fraction of the tolerance.
constexpr double kOnPlanes = 1.0 / 1024;
// How far vertices move at a time where parts touch, and how far in all, as fractions of the
// tolerance.
constexpr double kParting = 1.0 / 16;
constexpr double kMostParting = 1.0 / 4;
constexpr int kMostPartings = 2;  // between two rounds
// Sheets of which more pairs cross than this share of their hits cross each other as such.
constexpr double kMostCrossingSheets = 1.0 / 16;
// From this round on more than what is faulty is raised. Where parts far thinner than the tolerance
// touch each other over a long way, a few hits that are raised make their neighbours faulty, and so
// on along the contact.
constexpr int kPatience = 12;
// In how many rounds the hits that are raised reach twice as far.
constexpr int kDoubling = 2;
constexpr int kFurthest = 12;  // the largest power of two
// How far a vertex may come off the planes of its hits for that, as a fraction of the tolerance.
constexpr double kMostCentring = 1.0 / 4;

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
    for (int round = 1; !sheets_cross(crossing_pairs); ++round) {
      for (int i = 0; i < kMostPartings && !crossing_pairs.pairs().empty(); ++i) {
        const std::vector<HitId> changed = part_pairs(crossing_pairs, opened);
        if (changed.empty()) break;
        crossing_pairs.update(mesh_, changed);
      }
      hits_to_remake_.clear();
      raise_levels(crossing_pairs.triangles(), round);
      if (hits_to_remake_.empty()) break;
      report_progress(progress, 0.9 - 0.2 / (1 + round), "faces");
      crossing_pairs.update(mesh_, remake_part());
    }
    move_back(crossing_pairs);
    const auto refined = std::count_if(levels_.hits.begin(), levels_.hits.end(),
                                       [](auto level) { return level != EmbedLevel::kTriangle; });
    return {std::move(mesh_), std::move(log_), static_cast<Index>(refined),
            crossing_pairs.pairs().size() + crossing_pairs.flat()};
  }

 private:
  // Tells whether so many triangles of a sheet cross that no vertices part them.
  bool sheets_cross(const CrossingPairs& crossing_pairs) const {
    return view_.grid.sheet && static_cast<double>(crossing_pairs.pairs().size()) >
                                   kMostCrossingSheets * static_cast<double>(levels_.hits.size());
  }

  // Moves the loops' vertices a little off the sides of their leaves: nearly all triangles are then
  // safe from each other. In an open mesh only moves them into their leaves, so that vertices at
  // rims stay where they are.
  void move_loops_off_sides() {
    const double margin = loops_.open ? 0 : kMaxMargin / 2 * view_.grid.tolerance;
    const double least = std::min(least_margin(), margin);
    for (LoopId v = 0; v < loops_.vertices(); ++v) {
      const Vec3 position = off_leaf_sides(v, margin);
      const Vec3 nearest = off_leaf_sides(v, least);
      if (position != nearest && leaves_plane(v, position)) {
        moved_off_.push_back({v, position, nearest});
      }
      loops_.position[v] = position;
    }
  }

  // Moves vertices back to the planes of their hits, as far as nothing crosses for that.
  void move_back(CrossingPairs& crossing_pairs) {
    std::erase_if(moved_off_, [&](const MovedVertex& moved) {
      return mesh_.first_half_edge[moved.vertex] == kNone ||
             mesh_.position[moved.vertex] != moved.position;  // it has moved since
    });
    move_unless_crossing(moved_off_, crossing_pairs, mesh_);
    for (const double share : {1.0, 0.75, 0.5, 0.5, 0.5}) {
      move_unless_crossing(part_of_the_way(share), crossing_pairs, mesh_);
    }
  }

  // Returns the vertices that refining has moved off their planes, and where they would be the
  // given share of the way back.
  std::vector<MovedVertex> part_of_the_way(double share) const {
    std::vector<MovedVertex> off =
        find_links_off_planes(view_, loops_, kMostCentring * view_.grid.tolerance, mesh_);
    for (const auto& [v, before] : raised_) {
      if (mesh_.first_half_edge[v] == kNone) continue;
      const Vec3& position = mesh_.position[v];
      if (furthest_plane(view_, loops_, v, position) >
          furthest_plane(view_, loops_, v, before) + on_planes()) {
        off.push_back({v, position, before});
      }
    }
    for (MovedVertex& moved : off) {
      moved.better = rounded(moved.position + share * (moved.better - moved.position));
    }
    std::erase_if(off, [](const MovedVertex& moved) { return moved.better == moved.position; });
    return off;
  }

  // Tells whether the loop's vertex lies on the plane of a hit of it, and the point does not.
  bool leaves_plane(LoopId v, const Vec3& point) const {
    const double reach = on_planes();
    for (const HalfEdgeId h : loops_.ring(v)) {
      const Plane& plane = view_.grid.plane_of(loops_.hit[h / 3]);
      if (plane.distance(loops_.position[v]) <= reach && plane.distance(point) > reach) return true;
    }
    return false;
  }

  double on_planes() const { return kOnPlanes * view_.grid.tolerance; }

  // Returns the loop's position, at least so far off the sides of its leaf, or as far as the leaf's
  // size allows.
  Vec3 off_leaf_sides(LoopId v, double margin) const {
    return rounded(off_sides(view_.boxes[loops_.leaf[v]], 2 * margin, loops_.position[v]));
  }

  // Returns the margin, in lattice units, which shows that a vertex lies inside of its leaf,
  // whatever rounding to 32 bits does.
  double least_margin() const {
    const Lattice& lattice = view_.grid.lattice;
    const Vec3 far = lattice.to_model(Vec3::Constant(kLatticeSize));
    const double largest =
        std::max(lattice.origin.cwiseAbs().maxCoeff(), far.cwiseAbs().maxCoeff());
    return 2 * kClear + largest * std::numeric_limits<float>::epsilon() / 2 / lattice.step;
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
  // level are become nested. In late rounds raises the hits about them too. Lists the hits that are
  // to be made anew in `hits_to_remake_`: none if nothing can be raised any more.
  void raise_levels(const std::vector<TriangleId>& faulty, int round) {
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
    if (round >= kPatience) raise_hits_about(faulty, round);
  }

  // Raises the hits of these triangles and those about them to the highest level, the further the
  // later the round, unless that takes vertices off their planes.
  void raise_hits_about(const std::vector<TriangleId>& faulty, int round) {
    std::vector<HitId> hits;
    for (const TriangleId t : faulty) hits.push_back(mesh_.hit[t]);
    make_set(hits);
    const int doublings = std::clamp((round - kPatience) / kDoubling, 0, kFurthest);
    add_hits_about(hits, 1 << doublings);
    for (const HitId hit : hits) {
      if (stays_near(hit)) raise(hit, EmbedLevel::kCentred);
    }
  }

  // Tells whether the vertices of the hit's loops, where they are at the highest level, are near
  // the planes of the loops' hits.
  bool stays_near(HitId hit) const {
    const double reach = kMostCentring * view_.grid.tolerance;
    for (HalfEdgeId h = 3 * hit; h < 3 * hit + 3; ++h) {
      const LoopId v = loops_.vertex[h];
      if (levels_.loops[v] >= EmbedLevel::kCentred) continue;
      const Vec3 centre = loop_position(view_, loops_, v, EmbedLevel::kCentred);
      for (const HalfEdgeId near : loops_.ring(v)) {
        if (view_.grid.plane_of(loops_.hit[near / 3]).distance(centre) > reach) return false;
      }
    }
    return true;
  }

  // Appends the hits that share loops with these, those that share loops with them, and so on.
  void add_hits_about(std::vector<HitId>& hits, int rings) const {
    Marks known(levels_.hits.size());
    for (const HitId hit : hits) known.set(hit);
    for (std::size_t begin = 0; rings > 0 && begin < hits.size(); --rings) {
      for (const std::size_t end = hits.size(); begin < end; ++begin) {
        const HitId hit = hits[begin];
        for (HalfEdgeId h = 3 * hit; h < 3 * hit + 3; ++h) {
          for (const HalfEdgeId near : loops_.ring(loops_.vertex[h])) {
            if (!known.test_and_set(near / 3)) hits.push_back(near / 3);
          }
        }
      }
    }
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
      if (levels_.loops[v] < EmbedLevel::kOffSides && level >= EmbedLevel::kOffSides) {
        raised_.emplace_back(v, loops_.position[v]);
      }
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
    Restored part = restore(loops_, levels_, hits_to_remake_, mesh_, log_);
    add_vertices(view_, settings_, levels_, part.split, mesh_, log_, part.hits, part.one_sided);
    nest_loops_of_leaves(part.loops);
    std::vector<VertexId> corners = part.loops;
    for (const OneSidedVertex& m : part.one_sided) corners.push_back(m.vertex);
    mend_edges(view_, settings_, levels_, mesh_, log_,
               {part.hits, corners, first_vertex, first_triangle});
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

  // Returns the nearest point of the root cell, in lattice units, whose model coordinates are
  // 32-bit floats.
  Vec3 rounded(const Vec3& position) const {
    const Lattice& lattice = view_.grid.lattice;
    Vec3 p = single_precision(lattice, position);
    for (int axis = 0; axis < 3; ++axis) {
      const double low = lattice.origin[axis];
      const double high = low + lattice.step * kLatticeSize;
      if (p[axis] < low) p[axis] = next_single(static_cast<float>(low), low, high);
      if (p[axis] > high) p[axis] = next_single(static_cast<float>(high), low, high);
    }
    return lattice.to_lattice(p);
  }

  // Returns the float between two numbers that is the next to the given one, or that one.
  static float next_single(float value, double low, double high) {
    if (value < low) return std::nextafter(value, std::numeric_limits<float>::max());
    if (value > high) return std::nextafter(value, std::numeric_limits<float>::lowest());
    return value;
  }

  GridView view_;
  const FaceSettings& settings_;
  DualMesh loops_;  // one triangle a hit; its vertices move as levels rise
  DualMesh mesh_;   // made from `loops_`
  EditLog log_;     // what was done to `mesh_`
  EmbedLevels levels_;
  std::vector<MovedVertex> moved_off_;  // off sides, and thus off the plane of a hit
  // Loops, and where they were before they were raised.
  std::vector<std::pair<LoopId, Vec3>> raised_;
  std::vector<HitId> hits_to_remake_;  // in the present round, some of them several times
};

}  // namespace

Embedding embed(const GridView& view, const FaceSettings& settings, std::span<const LoopId> missed,
                const Progress& progress, DualMesh loops) {
  return Rounds(view, settings, std::move(loops)).run(missed, progress);
}

}  // namespace kdm
