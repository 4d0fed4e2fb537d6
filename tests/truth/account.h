// SPDX-License-Identifier: MIT
// The exact account of a solid: what its surface must be, whatever way the library takes there.
#pragma once

#include <set>
#include <utility>

#include "kdmanifold/mesh.h"
#include "truth/cells.h"

namespace kdm::truth {

/// Parts of a closed surface and its Euler characteristic.
using Topology = std::pair<int, int>;

/// What the topology of the surface may be. Where a solid touches itself along an edge or in a
/// vertex only, a 2-manifold has to part or to join it there, and either is right.
struct AllowedTopology {
  std::set<Topology> any_of;
  /// If there are too many contacts to try all: the least and the most that either number can be.
  bool ranges = false;
  Topology least;
  Topology most;

  bool holds(const Topology& found) const;
};

struct Account {
  double volume = 0;  ///< 0 if the input encloses nothing
  Mesh boundary;      ///< the surface of the solid, in triangles; it may touch itself
  AllowedTopology topology;
  int contacts = 0;  ///< edges and vertices where the surface touches itself
};

/// Takes the account of filled cells. Walls between filled cells do not count.
Account account_of(const Cells& cells, check::Random& diagonals);

/// Sums over the triangles of a closed mesh: its volume, by tetrahedra with the first vertex.
double volume_of(const Mesh& mesh);
double area_of(const Mesh& mesh);

}  // namespace kdm::truth
