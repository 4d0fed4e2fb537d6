// SPDX-License-Identifier: MIT
// Separates edges that join the same two vertices, so that the mesh is manifold also as an index
// mesh.
#include "extract/mend/double_edges.h"

#include "extract/dual/edit.h"
#include "extract/place/link_point.h"
#include "geometry/assert.h"
#include "geometry/quadric.h"
#include "mesh/sort.h"

namespace kdm {
namespace {

class Separation {
 public:
  Separation(const GridView& view, DualMesh& mesh, EditLog& log)
      : view_(view), mesh_(mesh), log_(log) {}

  Index run(const Scope& vertices) {
    const Index before = mesh_.vertices();
    // Of all vertices each edge is found once, from its lower end.
    vertices.for_each(before,
                      [&](VertexId v) { collect_doubles(v, vertices.is_all() ? v + 1 : 0); });
    while (!doubles_.empty()) {
      const auto [from, to] = doubles_.back();
      const Index half_edge = second_half_edge(from, to);
      if (half_edge == kNone) {
        doubles_.pop_back();
      } else {
        insert_vertex(half_edge);
      }
    }
    log_.note_added(AddedBy::kDoubleEdges, before, mesh_);
    return mesh_.vertices() - before;
  }

 private:
  // Vertices from `least` on that several half-edges of v's ring go to.
  void collect_doubles(Index v, Index least) {
    ring_.clear();
    for (const HalfEdgeId h : mesh_.ring(v)) {
      const VertexId to = mesh_.end_vertex(h);
      if (to >= least) ring_.push_back(to);
    }
    if (mesh_.on_boundary(v) && start_into(v) >= least) ring_.push_back(start_into(v));
    constexpr std::size_t kShort = 12;
    if (ring_.size() <= kShort) {
      bool doubled = false;
      for (std::size_t i = 1; i < ring_.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) doubled |= ring_[i] == ring_[j];
      }
      if (!doubled) return;
    }
    sort_numbers(ring_);
    for (std::size_t i = 1; i < ring_.size(); ++i) {
      if (ring_[i] == ring_[i - 1]) doubles_.emplace_back(v, ring_[i]);
    }
  }

  // Inserting a vertex moves half-edges about, so doubles are kept as pairs and looked up again.
  Index second_half_edge(Index from, Index to) const {
    int found = 0;
    for (const HalfEdgeId h : mesh_.ring(from)) {
      if (mesh_.end_vertex(h) == to && ++found == 2) return h;
    }
    if (found == 0 || !mesh_.on_boundary(from) || start_into(from) != to) return kNone;
    return mesh_.boundary_into(from);
  }

  // Returns the vertex in which the boundary half-edge that ends in v starts. v must be on the
  // boundary.
  Index start_into(Index v) const { return mesh_.vertex[mesh_.boundary_into(v)]; }

  void insert_vertex(Index ab) {
    log_.note_edited(mesh_.hit[ab / 3]);
    if (mesh_.opposite[ab] == kNone) {
      const Index b = mesh_.end_vertex(ab);
      divide_boundary(ab, 0.5 * (mesh_.position[mesh_.vertex[ab]] + mesh_.position[b]), mesh_);
      return;
    }
    const Index ba = mesh_.opposite[ab];
    log_.note_edited(mesh_.hit[ba / 3]);
    const Index c = mesh_.vertex[previous_in_triangle(ab)];
    const Index d = mesh_.vertex[previous_in_triangle(ba)];
    const Vec3 position = between(ab / 3, ba / 3, mesh_.vertex[ab], mesh_.vertex[ba]);
    const Index m = divide_edge(ab, position, mesh_);
    if (c == d) doubles_.emplace_back(m, c);
  }

  // Returns the point nearest to the edge's middle at which the planes of the two hits meet, within
  // the box of the edge and the hits. Where parts touch along an edge, it lies on this edge.
  Vec3 between(Index triangle, Index other, Index a, Index b) const {
    const Vec3& p = mesh_.position[a];
    const Vec3& q = mesh_.position[b];
    const Index hit = mesh_.hit[triangle];
    const Index other_hit = mesh_.hit[other];
    if (hit == other_hit) return 0.5 * (p + q);
    const Vec3& r = view_.hit_points[hit];
    const Vec3& s = view_.hit_points[other_hit];
    PrimalQuadric quadric(0.5 * (p + q));
    quadric.add(view_.grid.plane_of(hit));
    quadric.add(view_.grid.plane_of(other_hit));
    const Vec3 crease = quadric.minimiser_in(p.cwiseMin(q).cwiseMin(r).cwiseMin(s),
                                             p.cwiseMax(q).cwiseMax(r).cwiseMax(s));
    // A third face may cut it off: one of those round the edge's ends.
    std::vector<HitId> hits;
    for (const VertexId v : {a, b}) {
      for (const HalfEdgeId h : mesh_.ring(v)) hits.push_back(mesh_.hit[h / 3]);
    }
    return behind_planes(view_, {hit, other_hit}, hits, view_.grid.tolerance / 2, crease);
  }

  GridView view_;
  DualMesh& mesh_;
  EditLog& log_;
  std::vector<Index> ring_;
  std::vector<std::pair<Index, Index>> doubles_;  // vertices that may be joined more than once
};

}  // namespace

Index separate_double_edges(const GridView& view, DualMesh& mesh, EditLog& log,
                            const Scope& vertices) {
  return Separation(view, mesh, log).run(vertices);
}

}  // namespace kdm
