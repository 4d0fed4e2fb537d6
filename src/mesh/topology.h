// SPDX-License-Identifier: MIT
// Which triangles are neighbours, and whether the surface is closed.
#pragma once

#include <span>
#include <vector>

#include "mesh/disjoint_sets.h"
#include "mesh/numbers.h"
#include "mesh/sides.h"

namespace kdm {

/// How the sides of a triangle mesh meet along its edges.
struct Topology {
  /// For each side the side of another triangle that runs along the same edge in the other
  /// direction, or kNone if there is none or all are paired with other sides. Where an edge has
  /// four or more triangles, the sides of the two directions are paired in order of their numbers.
  std::vector<SideId> opposite;
  /// The sides on edges of three or more triangles, edge by edge, ascending on each edge.
  std::vector<SideId> non_manifold_sides;
  Index boundary_edges = 0;         ///< how many edges have one triangle
  Index non_manifold_edges = 0;     ///< how many edges have three or more triangles
  Index unbalanced_edges = 0;       ///< how many edges are not used equally often both ways
  SideId first_unbalanced = kNone;  ///< the lowest side on such an edge
  Index components = 0;             ///< how many parts there are if edges join triangles

  /// Whether every edge is used equally often in both directions.
  bool closed() const { return unbalanced_edges == 0; }
};

/// Finds how the sides of the triangles meet. `points` is above all corner numbers. Sides that lead
/// from a corner to the same corner are left out. Takes linear time if no point has very many
/// triangles.
Topology build_topology(std::span<const Triangle> triangles, Index points);

/// Joins all triangles that share an edge, however many there are and whichever way they run along
/// it; `points` is above all corner numbers. The topology must be theirs.
DisjointSets join_at_edges(std::span<const Triangle> triangles, Index points,
                           const Topology& topology);

/// Returns for each triangle the number of its part: of those that are connected with it through
/// joined sides. Returns nothing if all triangles are of one part.
std::vector<Index> find_parts(const Topology& topology);

}  // namespace kdm
