// SPDX-License-Identifier: MIT
// The dual surface as half-edges: one triangle a hit, one vertex a loop.
#pragma once

#include <vector>

#include "extract/dual/ring.h"
#include "grid/grid_data.h"

namespace kdm {

/// Half-edges 3t, 3t+1, 3t+2 run round triangle t. Triangle t is hit t's, until more are added.
struct DualMesh {
  std::vector<HalfEdgeId> opposite;  ///< kNone on the boundary
  std::vector<VertexId> vertex;      ///< in which the half-edge starts; kNone in dropped triangles
  std::vector<HitId> hit;            ///< per triangle: the hit it stands for
  std::vector<char> strip;           ///< per triangle: bit i, half-edge i crosses a strip
  std::vector<HalfEdgeId> first_half_edge;  ///< per vertex: one that starts there; on the boundary
                                            ///< the first of its ring; kNone: dropped
  std::vector<CellId> leaf;    ///< per vertex: the leaf it lies in; kNone for inserted ones
  std::vector<Vec3> position;  ///< per vertex, in lattice coordinates
  std::vector<LoopId> next_loop_in_leaf;  ///< per loop: the next one of its leaf, cyclically
  bool open = false;                      ///< there is a boundary

  Index triangles() const { return static_cast<Index>(hit.size()); }
  /// Counts vertices, also dropped ones.
  Index vertices() const { return static_cast<Index>(first_half_edge.size()); }
  bool dropped(TriangleId triangle) const { return vertex[3 * triangle] == kNone; }
  /// Appends triangle (a, b, c), unlinked; returns its first half-edge.
  HalfEdgeId add_triangle(HitId of_hit, VertexId a, VertexId b, VertexId c);
  void link(HalfEdgeId h, HalfEdgeId g) {
    opposite[h] = g;
    if (g != kNone) opposite[g] = h;
  }

  /// The half-edges that start in the vertex, once each, turning round it: all of them for a vertex
  /// off the boundary, and on the boundary from one side to the other. None of a dropped vertex.
  /// Valid until triangles are added or links change; vertices may change meanwhile.
  Ring ring(VertexId v) const { return {opposite.data(), first_half_edge[v]}; }
  /// The same, but begins with this half-edge; on the boundary without those before it.
  Ring ring_from(HalfEdgeId half_edge) const { return {opposite.data(), half_edge}; }
  /// The next half-edge of the ring round the vertex in which this one starts; kNone behind the
  /// boundary.
  HalfEdgeId next_in_ring(HalfEdgeId half_edge) const {
    return Ring::next(opposite.data(), half_edge);
  }
  /// The vertex in which the half-edge ends.
  VertexId end_vertex(HalfEdgeId half_edge) const { return vertex[next_in_triangle(half_edge)]; }

  /// The half-edge on the boundary that ends in the vertex; kNone if the vertex is not on it.
  HalfEdgeId boundary_into(VertexId v) const;
  bool on_boundary(VertexId v) const { return boundary_into(v) != kNone; }
  /// Makes the vertex's ring begin with this half-edge, which starts there; on the boundary with
  /// the first of the half-edges that this one is among.
  void set_first_half_edge(VertexId v, HalfEdgeId half_edge);
};

inline HalfEdgeId DualMesh::boundary_into(VertexId v) const {
  if (!open) return kNone;
  const HalfEdgeId before = previous_in_triangle(first_half_edge[v]);
  return opposite[before] == kNone ? before : kNone;
}

/// Place within the triangle of a hit's half-edge of this slot (see grid_data.h), and the slot of
/// the half-edge at this place: the same exchange of 1 and 2.
constexpr Index place_of_slot(Index slot, bool reversed) {
  return reversed || slot == 0 ? slot : 3 - slot;
}
constexpr Index slot_at_place(Index place, bool reversed) { return place_of_slot(place, reversed); }

/// Makes half-edges and links of the grid's. `vertex` holds the leaves in which half-edges start,
/// until `find_loops` numbers the vertices.
DualMesh dual_mesh_of(const GridData& grid);

/// Drops the parts without volume that a bulge leaves which pokes through one grid edge: two
/// triangles linked to each other on all sides, or the same with each of them a quad. Returns the
/// number of parts.
Index drop_pillows(DualMesh& mesh);

/// Finds the loops: every cycle of half-edges round a corner becomes a vertex (paper 2.2), and
/// every chain from boundary to boundary (2.3.2).
void find_loops(const GridData& grid, DualMesh& mesh);

/// Fills `next_loop_in_leaf`.
void find_loops_of_leaves(const GridData& grid, DualMesh& mesh);

}  // namespace kdm
