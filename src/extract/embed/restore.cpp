// SPDX-License-Identifier: MIT
// Takes back what was done to a part of a dual mesh.
//
// The part has to be so large that what is put back fits what stays around it. Call the link
// between two hits intact if each of the two half-edges is still a side of its hit's first
// triangle, with the same ends and the same opposite as in `loops`.
//
// Say that a link stays divided if neither hit is asked for, each has its first triangle, and the
// link's edge is two edges, each between a triangle of the one hit and one of the other, that meet
// in a vertex which `refine` put there. It would put it there again: the place depends on the
// levels of the hits and on their loops, and these are as before. But it has been rounded since,
// and nesting needs vertices right on the sides of leaves; so it must not lie across from a nested
// loop.
//
// The part R is made of the hits asked for and closed under three rules. With a hit, R holds
//
//   1. the hits that it is linked to by links that are neither intact nor stay divided,
//   2. all hits round its loops from which vertices were split off,
//   3. all hits round the other loops of its leaves where loops are nested, since that is done to
//      all loops of a leaf together.
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
//      back exactly what was there. The same holds for the two edges of a link that was divided.
//   3. So across an intact link lies a triangle that has not been changed together with one of R.
//      Its side there is a half-edge of `loops` with the same ends and the same opposite: the very
//      side to which the triangle that is put back was linked. Across a link that stays divided lie
//      two such sides, and the triangle that is put back is divided at their vertex again, once all
//      vertices of the part are found.
#include "extract/embed/restore.h"

#include <optional>

#include "mesh/marks.h"
#include "mesh/sort.h"

namespace kdm {
namespace {

class Restoring {
 public:
  Restoring(const DualMesh& loops, const EmbedLevels& levels, DualMesh& mesh, EditLog& log)
      : loops_(loops),
        levels_(levels),
        mesh_(mesh),
        log_(log),
        asked_(loops.hit.size()),
        included_(loops.hit.size()) {}

  Restored run(const std::vector<HitId>& hits) {
    for (const HitId hit : hits) {
      asked_.set(hit);
      include(hit);
    }
    for (std::size_t i = 0; i < part_.hits.size(); ++i) include_tied_to(part_.hits[i]);
    sort_numbers(part_.hits);
    for (const HitId hit : part_.hits) find_one_sided(hit);
    drop_added();
    for (const HitId hit : part_.hits) restore_triangle(hit);
    for (const OneSidedVertex& m : part_.one_sided) link_to_halves(m);
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
      if (!is_intact(h) && !vertex_that_stays(h)) include(opposite / 3);
      const LoopId v = loops_.vertex[h];
      if (is_nested(v)) include_hits_round(loops_.next_loop_in_leaf[v]);
      if (!log_.was_split(v)) continue;
      part_.split.push_back(v);
      log_.forget_split(v);
      include_hits_round(v);
    }
  }

  bool is_nested(LoopId v) const { return levels_.of_loop(v) == EmbedLevel::kNested; }

  // Lists the vertices of the hit's links on which the part ends and that stay divided.
  void find_one_sided(HitId hit) {
    for (HalfEdgeId h = 3 * hit; h < 3 * hit + 3; ++h) {
      if (is_intact(h) || included_.test(loops_.opposite[h] / 3)) continue;
      if (const auto m = vertex_that_stays(h)) part_.one_sided.push_back(*m);
    }
  }

  // Returns the vertex of the half-edge's link if the link stays divided.
  std::optional<OneSidedVertex> vertex_that_stays(HalfEdgeId h) const {
    const HalfEdgeId opposite = loops_.opposite[h];
    const HitId hit = h / 3;
    const HitId other = opposite / 3;
    if (loops_.open || asked_.test(hit) || asked_.test(other) || mesh_.hit[hit] != hit ||
        mesh_.hit[other] != other || is_nested(loops_.vertex[previous_in_triangle(h)])) {
      return {};
    }
    for (const HalfEdgeId to_m : mesh_.ring(loops_.vertex[h])) {
      const VertexId m = mesh_.end_vertex(to_m);
      if (!lies_between(to_m, hit, other) || !log_.has_added(AddedBy::kLinks, m)) continue;
      for (const HalfEdgeId from_m : mesh_.ring(m)) {
        if (mesh_.end_vertex(from_m) == loops_.vertex[opposite] &&
            lies_between(from_m, hit, other)) {
          return OneSidedVertex{m, h, opposite, mesh_.opposite[from_m], mesh_.opposite[to_m]};
        }
      }
    }
    return {};
  }

  bool lies_between(HalfEdgeId h, HitId hit, HitId other) const {
    return mesh_.hit[h / 3] == hit && mesh_.hit[mesh_.opposite[h] / 3] == other;
  }

  // Tells whether the half-edge's link is intact; so is the boundary.
  bool is_intact(HalfEdgeId h) const {
    const HalfEdgeId opposite = loops_.opposite[h];
    return opposite == kNone || (side_is_intact(h) && side_is_intact(opposite));
  }

  bool side_is_intact(HalfEdgeId h) const {
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
      const HalfEdgeId opposite = loops_.opposite[h];
      if (opposite == kNone || included_.test(opposite / 3)) mesh_.link(h, opposite);
    }
  }

  void link_to_halves(const OneSidedVertex& m) {
    mesh_.opposite[m.half_edge] = m.to_start;
    mesh_.opposite[m.from_end] = m.half_edge;
    mesh_.opposite[m.to_start] = m.half_edge;
    mesh_.first_half_edge[m.vertex] = m.to_start;
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
  const EmbedLevels& levels_;
  DualMesh& mesh_;
  EditLog& log_;
  Marks asked_;     // per hit: it was asked for
  Marks included_;  // per hit: it is in `part_`
  Restored part_;
};

}  // namespace

Restored restore(const DualMesh& loops, const EmbedLevels& levels, const std::vector<HitId>& hits,
                 DualMesh& mesh, EditLog& log) {
  return Restoring(loops, levels, mesh, log).run(hits);
}

}  // namespace kdm
