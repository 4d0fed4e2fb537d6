// SPDX-License-Identifier: MIT
// The dual surface as half-edges: one triangle a hit, one vertex a loop.
#pragma once

#include <vector>

#include "grid/grid_data.h"

namespace kdm {

/// Half-edges 3t, 3t+1, 3t+2 run round triangle t. Triangle t is hit t's, until more are added.
struct DualMesh {
  std::vector<Index> opposite;  ///< kNone on the boundary
  std::vector<Index> vertex;    ///< in which the half-edge starts; kNone in dropped triangles
  std::vector<Index> hit;       ///< per triangle: the hit it stands for
  std::vector<char> strip;      ///< per triangle: bit i, half-edge i crosses a strip
  std::vector<Index> first;     ///< per vertex: a half-edge that starts there; on the boundary, the
                                ///< one from which `turn` goes through all; kNone: dropped
  std::vector<Index> leaf;      ///< per vertex: the leaf it lies in; kNone for inserted ones
  std::vector<Vec3> position;   ///< per vertex, in lattice coordinates
  std::vector<char> edited;     ///< per hit: more was done to its triangles than division
  std::vector<Index> touched;   ///< hits whose triangles were edited or divided, in turn
  std::vector<char> cut;        ///< per loop: vertices were split off
  std::vector<Index> beside;    ///< per loop: the next one of its leaf, all round
  std::vector<char> through;    ///< per hit: bit i, as half-edge i was linked at first, the surface
                                ///< goes through the inside of the minimal face there
  Index dropped_pillows = 0;
  bool open = false;  ///< there is a boundary

  Index triangles() const { return static_cast<Index>(hit.size()); }
  bool dropped(Index triangle) const { return vertex[3 * triangle] == kNone; }
  /// Notes that flips, splits or separated edges change the triangles of this hit.
  void mark_edited(Index of_hit) {
    if (edited.size() <= of_hit) edited.resize(of_hit + 1, 0);
    edited[of_hit] = 1;
    touched.push_back(of_hit);
  }

  /// Appends triangle (a, b, c), unlinked; returns its first half-edge.
  Index add_triangle(Index of_hit, Index a, Index b, Index c);
  void link(Index h, Index g) {
    opposite[h] = g;
    if (g != kNone) opposite[g] = h;
  }
  /// The next half-edge round the vertex in which this one starts; kNone behind the boundary.
  Index turn(Index half_edge) const;
  /// The half-edge on the boundary that ends in the vertex; kNone if the vertex is not on it.
  Index boundary_into(Index v) const;
  /// Makes a half-edge that starts in the vertex lead to its `first`.
  void set_first(Index v, Index half_edge);
};

constexpr Index next_in_triangle(Index half_edge) {
  return half_edge % 3 == 2 ? half_edge - 2 : half_edge + 1;
}
constexpr Index previous_in_triangle(Index half_edge) {
  return half_edge % 3 == 0 ? half_edge + 2 : half_edge - 1;
}

inline Index DualMesh::turn(Index half_edge) const {
  const Index other = opposite[half_edge];
  return other == kNone ? kNone : next_in_triangle(other);
}
inline Index DualMesh::boundary_into(Index v) const {
  if (!open) return kNone;
  const Index before = previous_in_triangle(first[v]);
  return opposite[before] == kNone ? before : kNone;
}

/// Place within the triangle of a hit's half-edge of this slot (see grid_data.h), and the slot of
/// the half-edge at this place: the same exchange of 1 and 2.
constexpr Index place_of_slot(Index slot, bool reversed) {
  return reversed || slot == 0 ? slot : 3 - slot;
}
constexpr Index slot_at_place(Index place, bool reversed) { return place_of_slot(place, reversed); }

/// Half-edges and links of the grid, still without vertices.
DualMesh dual_mesh_of(const GridData& grid);

/// Marks the parts without volume that a bulge leaves which pokes through one grid edge: two
/// triangles linked to each other on all sides, or the same with each of them a quad.
void drop_pillows(DualMesh& mesh);

/// Finds the loops: every cycle of half-edges round a corner becomes a vertex (paper 2.2), and
/// every chain from boundary to boundary (2.3.2).
void find_loops(const GridData& grid, DualMesh& mesh);

/// Finds which loops are in a leaf together.
void find_beside(const GridData& grid, DualMesh& mesh);

}  // namespace kdm
