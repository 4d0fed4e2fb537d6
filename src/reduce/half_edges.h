// SPDX-License-Identifier: MIT
// A triangle mesh that loses edges: half-edges in flat arrays.
//
// Half-edge 3t + i is the side of triangle t that starts at its corner i (see mesh/sides.h). It
// leads along an edge that another half-edge, its opposite, runs along the other way; on the
// boundary of a sheet there is none.
#pragma once

#include <span>
#include <vector>

#include "mesh/marks.h"
#include "mesh/numbers.h"
#include "mesh/sides.h"

namespace kdm {

/// The numbers, in a mesh, of the triangles and vertices of a part of it: ascending.
struct PartNumbers {
  std::vector<TriangleId> triangles;
  std::vector<VertexId> vertices;

  /// Returns the number in the mesh of a side of the part; of kNone that is kNone.
  SideId whole_side(SideId h) const {
    return h == kNone ? kNone : 3 * triangles[triangle_of(h)] + corner_of(h);
  }
  VertexId whole_vertex(VertexId v) const { return v == kNone ? kNone : vertices[v]; }
  /// Returns the number in the part of a vertex, which must be there.
  VertexId vertex(VertexId whole) const;
  /// Returns the number in the part of a side; kNone if its triangle is not there, or for kNone.
  SideId side(SideId whole) const;
};

/// The mesh. A triangle that was removed has no vertices any more, and a vertex that was removed no
/// half-edge; numbers stay what they were.
class HalfEdges {
 public:
  /// Throws `kInvalidMesh` unless every edge has two triangles that run against each other, or one,
  /// and the triangles of every vertex form one fan. `vertices` is above all corner numbers.
  HalfEdges(std::span<const Triangle> triangles, Index vertices);
  /// Copies some triangles of a mesh, none of which may have been removed. Where a neighbour is not
  /// copied, there is none. Vertices may have several fans that way; nothing at these may be asked
  /// for or changed.
  HalfEdges(const HalfEdges& whole, const PartNumbers& part);

  /// Takes over what has become of a part that was copied from this mesh: of its triangles that
  /// `owned` marks, and of the vertices that `inside` does. Nothing else may have been changed in
  /// the part. Parts that own nothing together may be put back at a time.
  void put_back(const HalfEdges& copied, const PartNumbers& part, const Marks& owned,
                const Marks& inside);
  /// Makes known how many triangles went in parts that were put back.
  void count_removed(Index triangles) { living_ -= triangles; }

  Index triangles() const { return static_cast<Index>(start_.size() / 3); }
  Index vertices() const { return static_cast<Index>(leaving_.size()); }
  Index living_triangles() const { return living_; }

  bool is_removed(TriangleId t) const { return start_[3 * t] == kNone; }
  VertexId start(SideId h) const { return start_[h]; }
  VertexId end(SideId h) const { return start_[next_side(h)]; }
  SideId opposite(SideId h) const { return opposite_[h]; }
  Triangle corners(TriangleId t) const {
    return {start_[3 * t], start_[3 * t + 1], start_[3 * t + 2]};
  }
  /// A half-edge that starts at the vertex; kNone if the vertex has no triangle. On the boundary it
  /// is the one without opposite.
  SideId leaving(VertexId v) const { return leaving_[v]; }
  bool on_boundary(VertexId v) const { return opposite_[leaving_[v]] == kNone; }

  /// The half-edge by which the edge of `h` is known: the lower one of the two.
  SideId edge(SideId h) const { return opposite_[h] < h ? opposite_[h] : h; }
  /// Tells whether the half-edge is the one by which an edge of a triangle that is left is known.
  bool is_edge(SideId h) const { return !is_removed(triangle_of(h)) && edge(h) == h; }

  /// Calls `visit(h)` for each half-edge that starts at the vertex, counter-clockwise.
  template <typename Visit>
  void for_each_leaving(VertexId v, const Visit& visit) const {
    const SideId first = leaving_[v];
    SideId h = first;
    do {
      visit(h);
      h = opposite_[previous_side(h)];
    } while (h != first && h != kNone);
  }

  /// Calls `visit(h)` for each edge at the vertex, with the half-edge by which it is known.
  template <typename Visit>
  void for_each_edge(VertexId v, const Visit& visit) const {
    for_each_leaving(v, [&](SideId h) {
      visit(edge(h));
      const SideId entering = previous_side(h);
      if (opposite_[entering] == kNone) visit(entering);
    });
  }

  /// Calls `visit(w)` for each vertex that an edge joins with `v`.
  template <typename Visit>
  void for_each_neighbour(VertexId v, const Visit& visit) const {
    for_each_leaving(v, [&](SideId h) {
      visit(end(h));
      const SideId entering = previous_side(h);
      if (opposite_[entering] == kNone) visit(start_[entering]);
    });
  }

  /// Joins the end of `h` with its start, which stays, and removes the triangles on both sides. The
  /// edge must meet the link condition: the two ends have no common neighbours but the tips of
  /// these triangles, and do not both lie on the boundary unless the edge does.
  void collapse(SideId h);

  /// Turns the edge of `h` within the two triangles beside it: it then joins their tips. They must
  /// not be neighbours yet.
  void flip(SideId h);

 private:
  void check_fans() const;
  void join(SideId a, SideId b);
  void remove_triangle(TriangleId t);
  void settle(VertexId v, SideId h);

  std::vector<VertexId> start_;   // per half-edge
  std::vector<SideId> opposite_;  // per half-edge
  std::vector<SideId> leaving_;   // per vertex
  Index living_ = 0;
};

}  // namespace kdm
