// SPDX-License-Identifier: MIT
// Adds vertices at hits and links.
#include "extract/place/refine.h"

#include <algorithm>
#include <cmath>

#include "extract/dual/clearance.h"
#include "extract/dual/edit.h"
#include "extract/place/link_point.h"
#include "geometry/distance.h"
#include "mesh/sort.h"

namespace kdm {
namespace {

class Refinement {
 public:
  Refinement(const GridView& view, const EmbedLevels& levels, double distance, DualMesh& mesh,
             EditLog& log, std::span<const OneSidedVertex> one_sided)
      : view_(view),
        levels_(levels),
        distance_(distance),
        mesh_(mesh),
        log_(log),
        one_sided_(one_sided) {}

  // All new vertices are found before anything is divided, so half-edge h still belongs to hit h /
  // 3.
  void find(const Scope& hits) {
    hits.for_each(static_cast<Index>(view_.hit_points.size()),
                  [&](HitId hit) { look_at(hit, hits); });
  }

  void divide() {
    Division division(mesh_, one_sided_);
    // Hits first: what is divided later is joined to them.
    for (const Index t : triangles_) division.triangle(t, view_.hit_points[t]);
    divide_at(strips_, division);
    divide_at(links_, division);
  }

  bool empty() const { return triangles_.empty() && strips_.empty() && links_.empty(); }

 private:
  // A vertex on the edge between two half-edges.
  struct Crossing {
    Index half_edge;
    Index other;
    Vec3 position;
    const OneSidedVertex* one_sided = nullptr;  // the vertex, if the other side has it
  };

  // Divides in the order of the links' lower half-edges, whether the hits beyond are looked at or
  // not: then triangles are divided in the same way.
  void divide_at(const std::vector<Crossing>& crossings, Division& division) {
    const auto lower = [&](Index i) {
      return std::min(crossings[i].half_edge, crossings[i].other);
    };
    const auto before = [&](Index i, Index j) { return lower(i) < lower(j); };
    for (const Index i : in_order(crossings.size(), Order(before))) {
      const Crossing& c = crossings[i];
      if (c.one_sided != nullptr) {
        division.side(*c.one_sided);
        continue;
      }
      log_.note_divided(c.half_edge / 3);
      log_.note_divided(c.other / 3);
      division.edge(c.half_edge, c.position);
    }
  }

  // A link is looked at from its lower half-edge, or from the one whose hit is looked at.
  void look_at(HitId t, const Scope& hits) {
    if (mesh_.dropped(t)) return;
    const auto half_edges = static_cast<Index>(3 * view_.hit_points.size());
    for (Index h = 3 * t; h < 3 * t + 3; ++h) {
      if (passed_ < one_sided_.size() && one_sided_[passed_].half_edge == h) {
        const OneSidedVertex& m = one_sided_[passed_++];
        (is_strip(h) ? strips_ : links_).push_back({h, m.opposite, mesh_.position[m.vertex], &m});
        continue;
      }
      const Index other = mesh_.opposite[h];
      if (other >= half_edges || (other < h && hits.contains(other / 3))) continue;
      if (is_strip(h)) {
        // Two hits at one point: one vertex, on the edge between their triangles.
        if (level_of_link(t, other / 3) != EmbedLevel::kTriangle)
          strips_.push_back({h, other, view_.hit_points[t]});
      } else {
        look_at_link(h, other);
      }
    }
    if (mesh_.strip[t] == 0 && levels_.of_hit(t) != EmbedLevel::kTriangle) triangles_.push_back(t);
  }

  bool is_strip(Index h) const { return (mesh_.strip[h / 3] >> (h % 3) & 1) != 0; }

  EmbedLevel level_of_link(Index hit, Index other) const {
    return std::max(levels_.of_hit(hit), levels_.of_hit(other));
  }

  void look_at_link(Index h, Index other) {
    const Index a = mesh_.vertex[h];
    const Index b = mesh_.vertex[other];
    const std::optional<LinkFace> face =
        face_between(view_.boxes[mesh_.leaf[a]], view_.boxes[mesh_.leaf[b]]);
    if (!face) return;
    const Vec3& p = mesh_.position[a];
    const Vec3& q = mesh_.position[b];
    const EmbedLevel level = level_of_link(h / 3, other / 3);
    const Vec3 crossing = crossing_point(*face, p, q);
    std::optional<Vec3> vertex = vertex_on(*face, level, h, other, crossing);
    bool inside_face = within(*face, crossing) && !nearly_parallel(q - p, face->axis);
    if (vertex) {
      // Arcs over one edge must stay nested.
      if (level < EmbedLevel::kLinksApart) *vertex = off_sides(*face, *vertex, levels_.margin);
      links_.push_back({h, other, *vertex});
      inside_face = within(*face, *vertex);
    }
    log_.note_link(h, inside_face);
    log_.note_link(other, inside_face);
  }

  // Returns the vertex that the link needs, if it needs one.
  std::optional<Vec3> vertex_on(const LinkFace& face, EmbedLevel level, Index half_edge,
                                Index opposite, const Vec3& crossing) {
    const Index hit = half_edge / 3;
    const Index other = opposite / 3;
    if (level == EmbedLevel::kTriangle &&
        (keeps_edge(half_edge) || meets_planes(face, hit, other, crossing))) {
      return std::nullopt;
    }
    if (level >= EmbedLevel::kLinksApart) {
      std::vector<HitPair> links;
      if (levels_.plain != nullptr) links = links_beside(*levels_.plain, half_edge);
      return chord_point(view_, face, {hit, other}, links);
    }
    const Vec3 corner = crease_point(view_, face, {hit, other}, {}, distance_);
    const bool wanted = level == EmbedLevel::kHitVertices || level == EmbedLevel::kOffSides ||
                        misses(hit, corner, other, crossing);
    if (!wanted) return std::nullopt;
    find_hits_beside(half_edge, opposite);
    return crease_point(view_, face, {hit, other}, beside_, distance_);
  }

  bool keeps_edge(Index half_edge) const {
    return mesh_.keeps_edges(mesh_.vertex[half_edge]) ||
           mesh_.keeps_edges(mesh_.end_vertex(half_edge));
  }

  // Collects the hits of the loops on both sides of the link.
  void find_hits_beside(Index half_edge, Index opposite) {
    beside_.clear();
    for (const HalfEdgeId first : {half_edge, opposite}) {
      for (const HalfEdgeId h : mesh_.ring_from(first)) beside_.push_back(mesh_.hit[h / 3]);
    }
  }

  // Returns all links between the two leaves of the half-edge's link.
  static std::vector<HitPair> links_beside(const DualMesh& plain, Index link) {
    const auto leaf_beyond = [&](Index h) { return plain.leaf[plain.end_vertex(h)]; };
    std::vector<HitPair> links;
    const Index first = plain.vertex[link];
    Index v = first;
    do {
      for (const HalfEdgeId h : plain.ring(v)) {
        const HalfEdgeId other = plain.opposite[h];
        const bool strip = (plain.strip[h / 3] >> (h % 3) & 1) != 0;
        if (other != kNone && !strip && leaf_beyond(h) == leaf_beyond(link)) {
          links.push_back({h / 3, other / 3});
        }
      }
      v = plain.next_loop_in_leaf[v];
    } while (v != first);
    return links;
  }

  static Vec3 crossing_point(const LinkFace& face, const Vec3& p, const Vec3& q) {
    const double across = q[face.axis] - p[face.axis];
    if (across == 0) return 0.5 * (p + q);
    return p + std::clamp((face.lo[face.axis] - p[face.axis]) / across, 0.0, 1.0) * (q - p);
  }

  // Tells whether the edge passes through the face, and so near to the planes of both hits that the
  // root of the sum of the squared distances is within the limit. It may be further from the lines
  // in which the planes cut the face, where the surface runs along the face.
  bool meets_planes(const LinkFace& face, Index hit, Index other, const Vec3& crossing) const {
    const double first = view_.grid.plane_of(hit).distance(crossing);
    const double second = view_.grid.plane_of(other).distance(crossing);
    return first * first + second * second <= distance_ * distance_ &&
           (crossing.array() >= face.lo.array() - distance_).all() &&
           (crossing.array() <= face.hi.array() + distance_).all();
  }

  // Tells whether the crossing is too far from the line that leads from one hit by the corner to
  // the other hit.
  bool misses(Index hit, const Vec3& corner, Index other, const Vec3& crossing) const {
    return std::min(squared_distance(crossing, view_.hit_points[hit], corner),
                    squared_distance(crossing, corner, view_.hit_points[other])) >
           distance_ * distance_;
  }

  GridView view_;
  const EmbedLevels& levels_;
  double distance_;
  DualMesh& mesh_;
  EditLog& log_;
  std::span<const OneSidedVertex> one_sided_;
  std::size_t passed_ = 0;        // how many of these were met
  std::vector<Index> triangles_;  // of hits that become vertices
  std::vector<Crossing> strips_;  // between two hits that become one vertex
  std::vector<Crossing> links_;
  std::vector<Index> beside_;  // hits of the loops on both sides of the link at hand
};

}  // namespace

Index refine(const GridView& view, const EmbedLevels& levels, double distance, DualMesh& mesh,
             EditLog& log, const Scope& hits, std::span<const OneSidedVertex> one_sided) {
  const Index before = mesh.vertices();
  Refinement refinement(view, levels, distance, mesh, log, one_sided);
  refinement.find(hits);
  if (!refinement.empty()) refinement.divide();
  log.note_added(AddedBy::kLinks, before, mesh);
  return mesh.vertices() - before;
}

}  // namespace kdm
