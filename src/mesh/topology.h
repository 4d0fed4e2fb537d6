// SPDX-License-Identifier: MIT
// Which triangle lies beyond each side of each triangle, and whether the surface is closed.
#pragma once

#include <span>
#include <vector>

#include "kdmanifold/types.h"
#include "mesh/edge_sides.h"

namespace kdm {

/// Neighbours of a triangle mesh. Side i of triangle t, from corner i to corner i+1, is 3t+i.
struct Topology {
  /// The side that runs along the same edge the other way; kNone on open edges. Where an edge has
  /// four or more triangles, sides of opposite direction are paired in order of their numbers.
  std::vector<Index> twin;
  std::vector<Index> crowded;      ///< sides on edges with three or more, edge by edge, ascending
  Index boundary_edges = 0;        ///< edges with one triangle
  Index non_manifold_edges = 0;    ///< edges with three or more triangles
  Index unbalanced_edges = 0;      ///< edges not used equally often in both directions
  Index first_unbalanced = kNone;  ///< the lowest side on such an edge
  Index components = 0;            ///< parts joined by edges

  bool closed() const { return unbalanced_edges == 0; }
};

/// Sides from a corner to an equal corner are ignored. `points` bounds the corner numbers.
Topology build_topology(std::span<const Triangle> triangles, Index points);

}  // namespace kdm
