// SPDX-License-Identifier: MIT
// Takes back what was done to a part of a dual mesh.
//
// The part has to be so large that what is put back fits what stays around it. Call the link
// between two hits intact if each of the two half-edges is still a side of its hit's first
// triangle, with the same ends and the same opposite as in `loops`.
//
// The part R is made of the hits asked for and closed under three rules. With a hit, R holds
//
//   1. the hits that it is linked to by links that are not intact,
//   2. all hits round its loops from which vertices were split off,
//   3. all hits round the other loops of its leaves, since loops of a leaf are placed and nested
//      together.
//
// Claim: all triangles that were changed together with triangles of R are triangles of R, and the
// sides on which triangles of R meet others are as in `loops`. So R can be put back alone.
//
//   1. A step that changes the triangles of one hit only, and none of its outer sides, as the
//      division of a triangle at its hit does, leaves all links of the hit as they are.
//   2. A step that changes triangles of several hits together divides, flips or separates an edge
//      between two of them, splits a loop's vertex, or nests the loops of a leaf. Dividing,
//      flipping and separating replaces half-edges or their ends, and so spoils the links between
//      all hits whose triangles it changes, or exchanges; rule 1 leads across such links, rules 2
//      and 3 to all hits of the other steps. A later step may only mend a spoiled link by bringing
//      back exactly what was there.
//   3. So across an intact link lies a triangle that has not been changed together with one of R.
//      Its side there is a half-edge of `loops` with the same ends and the same opposite: the very
//      side to which the triangle that is put back was linked.
#include "extract/embed/restore.h"

#include "mesh/marks.h"
#include "mesh/sort.h"

namespace kdm {
namespace {

class Restoring {
 public:
  Restoring(const DualMesh& loops, DualMesh& mesh, EditLog& log)
      : loops_(loops), mesh_(mesh), log_(log), included_(loops.hit.size()) {}

  Restored run(const std::vector<HitId>& hits) {
    for (const HitId hit : hits) include(hit);
    for (std::size_t i = 0; i < part_.hits.size(); ++i) include_tied_to(part_.hits[i]);
    sort_numbers(part_.hits);
    drop_added();
    for (const HitId hit : part_.hits) restore_triangle(hit);
    for (const HitId hit : part_.hits) restore_vertices(hit);
    make_set(part_.loops);
    make_set(part_.split);
    return std::move(part_);
  }

 private:
  void include(HitId hit) {
    if (loops_.dropped(hit) || included_.test_and_set(hit)) return;
    part_.hits.push_back(hit);
  }

  void include_hits_round(LoopId v) {
    for (const HalfEdgeId h : loops_.ring(v)) include(h / 3);
  }

  // Includes the hits to which the three rules lead from this one.
  void include_tied_to(HitId hit) {
    for (HalfEdgeId h = 3 * hit; h < 3 * hit + 3; ++h) {
      const HalfEdgeId opposite = loops_.opposite[h];
      if (opposite != kNone && !(is_intact(h) && is_intact(opposite))) include(opposite / 3);
      const LoopId v = loops_.vertex[h];
      if (!loops_.next_loop_in_leaf.empty() && loops_.next_loop_in_leaf[v] != v) {
        include_hits_round(loops_.next_loop_in_leaf[v]);
      }
      if (!log_.was_split(v)) continue;
      part_.split.push_back(v);
      log_.forget_split(v);
      include_hits_round(v);
    }
  }

  bool is_intact(HalfEdgeId h) const {
    return mesh_.hit[h / 3] == h / 3 && mesh_.opposite[h] == loops_.opposite[h] &&
           mesh_.vertex[h] == loops_.vertex[h] && mesh_.end_vertex(h) == loops_.end_vertex(h);
  }

  void drop_added() {
    for (const HitId hit : part_.hits) drop_added_corners(hit);
    for (TriangleId t = loops_.triangles(); t < mesh_.triangles(); ++t) {
      if (mesh_.dropped(t) || !included_.test(mesh_.hit[t])) continue;
      drop_added_corners(t);
      for (HalfEdgeId h = 3 * t; h < 3 * t + 3; ++h) mesh_.vertex[h] = kNone;
    }
  }

  void drop_added_corners(TriangleId t) {
    for (HalfEdgeId h = 3 * t; h < 3 * t + 3; ++h) {
      const VertexId v = mesh_.vertex[h];
      if (v >= loops_.vertices()) mesh_.first_half_edge[v] = kNone;
    }
  }

  void restore_triangle(HitId hit) {
    mesh_.hit[hit] = hit;
    mesh_.strip[hit] = loops_.strip[hit];
    log_.forget_edits(hit);
    for (HalfEdgeId h = 3 * hit; h < 3 * hit + 3; ++h) {
      mesh_.vertex[h] = loops_.vertex[h];
      mesh_.link(h, loops_.opposite[h]);
    }
  }

  void restore_vertices(HitId hit) {
    for (HalfEdgeId h = 3 * hit; h < 3 * hit + 3; ++h) {
      const LoopId v = loops_.vertex[h];
      part_.loops.push_back(v);
      mesh_.position[v] = loops_.position[v];
      mesh_.set_first_half_edge(v, h);
    }
  }

  const DualMesh& loops_;
  DualMesh& mesh_;
  EditLog& log_;
  Marks included_;  // per hit: it is in `part_`
  Restored part_;
};

}  // namespace

Restored restore(const DualMesh& loops, const std::vector<HitId>& hits, DualMesh& mesh,
                 EditLog& log) {
  return Restoring(loops, mesh, log).run(hits);
}

}  // namespace kdm
