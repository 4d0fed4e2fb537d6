// SPDX-License-Identifier: MIT
// The dual surface as half-edges: one triangle a hit, one vertex a loop.
#pragma once

#include <vector>

#include "grid/grid_data.h"

namespace kdm {

/// Half-edges 3t, 3t+1, 3t+2 run round triangle t. Triangle t is hit t's, until more are added.
struct DualMesh {
  std::vector<Index> opposite;
  std::vector<Index> vertex;   ///< in which the half-edge starts; kNone in dropped triangles
  std::vector<Index> hit;      ///< per triangle: the hit it stands for
  std::vector<char> strip;     ///< per triangle: bit i, half-edge i crosses a strip
  std::vector<Index> first;    ///< per vertex: one half-edge that starts there
  std::vector<Index> leaf;     ///< per vertex: the leaf it lies in; kNone for inserted ones
  std::vector<Vec3> position;  ///< per vertex, in lattice coordinates
  Index dropped_pillows = 0;

  Index triangles() const { return static_cast<Index>(hit.size()); }
  bool dropped(Index triangle) const { return vertex[3 * triangle] == kNone; }

  /// Appends triangle (a, b, c), unlinked; returns its first half-edge.
  Index add_triangle(Index of_hit, Index a, Index b, Index c);
  void link(Index h, Index g) {
    opposite[h] = g;
    opposite[g] = h;
  }
};

constexpr Index next_in_triangle(Index half_edge) {
  return half_edge % 3 == 2 ? half_edge - 2 : half_edge + 1;
}
constexpr Index previous_in_triangle(Index half_edge) {
  return half_edge % 3 == 0 ? half_edge + 2 : half_edge - 1;
}

/// Half-edges and links of the grid, still without vertices.
DualMesh dual_mesh_of(const GridData& grid);

/// Marks the parts without volume that a bulge leaves which pokes through one grid edge: two
/// triangles linked to each other on all sides, or the same with each of them a quad.
void drop_pillows(DualMesh& mesh);

/// Finds the loops: every cycle of half-edges round a corner becomes a vertex (paper 2.2).
void find_loops(const GridData& grid, DualMesh& mesh);

}  // namespace kdm
