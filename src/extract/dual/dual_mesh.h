// SPDX-License-Identifier: MIT
// Represents the dual surface as half-edges: at first with one triangle for each hit and one vertex
// for each loop.
#pragma once

#include <vector>

#include "extract/dual/ring.h"
#include "grid/grid_data.h"
#include "mesh/marks.h"

namespace kdm {

/// A triangle mesh of half-edges. Half-edges 3t, 3t+1, 3t+2 run round triangle t. At first triangle
/// t stands for hit t; triangles that are added later have higher numbers.
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
  Marks joined;                           ///< per loop: `KeptCorner::joined`; empty if none is

  Index triangles() const { return static_cast<Index>(hit.size()); }
  /// Counts vertices, also dropped ones.
  Index vertices() const { return static_cast<Index>(first_half_edge.size()); }
  bool dropped(TriangleId triangle) const { return vertex[3 * triangle] == kNone; }
  /// Tells whether the edges of the vertex stay as they are.
  bool keeps_edges(VertexId v) const { return v < joined.size() && joined.test(v); }
  /// Appends triangle (a, b, c), which stands for hit `of_hit` and has no links. Returns its first
  /// half-edge.
  HalfEdgeId add_triangle(HitId of_hit, VertexId a, VertexId b, VertexId c);
  void link(HalfEdgeId h, HalfEdgeId g) {
    opposite[h] = g;
    if (g != kNone) opposite[g] = h;
  }

  /// Returns the half-edges that start in the vertex, each once, in the order in which they lie
  /// round it; on the boundary, from one boundary edge to the other. A dropped vertex has none.
  /// Valid until triangles are added or links change; vertices may change meanwhile.
  Ring ring(VertexId v) const { return {opposite.data(), first_half_edge[v]}; }
  /// Returns the ring round the vertex in which this half-edge starts, beginning with this
  /// half-edge; on the boundary, the half-edges before it are left out.
  Ring ring_from(HalfEdgeId half_edge) const { return {opposite.data(), half_edge}; }
  /// Returns the next half-edge of the ring round the vertex in which this one starts; kNone if
  /// this one is the last before the boundary.
  HalfEdgeId next_in_ring(HalfEdgeId half_edge) const {
    return Ring::next(opposite.data(), half_edge);
  }
  /// Returns the vertex in which the half-edge ends.
  VertexId end_vertex(HalfEdgeId half_edge) const { return vertex[next_in_triangle(half_edge)]; }

  /// Returns the half-edge on the boundary that ends in the vertex; kNone if the vertex is not on
  /// the boundary.
  HalfEdgeId boundary_into(VertexId v) const;
  bool on_boundary(VertexId v) const { return boundary_into(v) != kNone; }
  /// Makes the vertex's ring begin with this half-edge, which must start in the vertex; on the
  /// boundary, makes it begin with the first half-edge of the ring that this one is in.
  void set_first_half_edge(VertexId v, HalfEdgeId half_edge);
};

inline HalfEdgeId DualMesh::boundary_into(VertexId v) const {
  if (!open) return kNone;
  const HalfEdgeId before = previous_in_triangle(first_half_edge[v]);
  return opposite[before] == kNone ? before : kNone;
}

/// Return the place (0 to 2) within its triangle of a hit's half-edge with this slot (see
/// grid_data.h), and the slot of the half-edge at this place. Both exchange 1 and 2 unless the hit
/// is reversed.
constexpr Index place_of_slot(Index slot, bool reversed) {
  return reversed || slot == 0 ? slot : 3 - slot;
}
constexpr Index slot_at_place(Index place, bool reversed) { return place_of_slot(place, reversed); }

/// Makes a mesh of the grid's half-edges and links, with one triangle for each hit. In the result,
/// `vertex` holds the leaves in which half-edges start, until `find_loops` numbers the vertices.
DualMesh dual_mesh_of(const GridData& grid);

/// Drops pillows, parts without volume (grid/pillows.h). Returns the number of parts dropped.
Index drop_pillows(DualMesh& mesh);

/// Finds the loops: every cycle of half-edges that start round a corner becomes a vertex (paper
/// 2.2), and so does every chain of them from boundary to boundary (paper 2.3.2).
void find_loops(const GridData& grid, DualMesh& mesh);

/// Fills `next_loop_in_leaf`.
void find_loops_of_leaves(const GridData& grid, DualMesh& mesh);

}  // namespace kdm
