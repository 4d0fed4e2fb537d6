// SPDX-License-Identifier: MIT
// Turning triangles so that neighbours agree.
#pragma once

#include <span>
#include <vector>

#include "kdmanifold/types.h"

namespace kdm {

/// A set of triangles that edges join; where most of its area looks is its direction.
struct PartDirection {
  Index first = kNone;     ///< its lowest triangle
  Index triangles = 0;     ///< copies among them
  double area = 0;         ///< without copies
  double agreeing = 0;     ///< how much of it keeps its direction, at least half
  bool closed = true;      ///< once turned, it uses every edge equally often in both directions
  bool oriented = true;    ///< none of its triangles has to be turned against the others
  bool orientable = true;  ///< no contradiction stays
};

struct NeighbourDirections {
  std::vector<char> flip;   ///< 1: this triangle must be turned
  std::vector<Index> part;  ///< of each triangle
  /// The first triangle over the same three corners, if there is an earlier one, else kNone. Copies
  /// are turned as it is and belong to its part.
  std::vector<Index> copy_of;
  std::vector<PartDirection> parts;  ///< in order of their first triangles
  Index contradictions = 0;          ///< edges of two triangles that cannot agree (Moebius strips)
};

/// Finds the parts, joined by edges of exactly two triangles (copies count once; edges of more do
/// not tell which of them continue each other), and turns the lesser area of each where its
/// triangles disagree. Where a part cannot be oriented, contradictions stay between triangles that
/// contradicted each other before, on the shortest edges that will do. `points` must be scaled
/// so that squares of areas are in range. n log n in the edges that disagree, else linear.
NeighbourDirections orient_neighbours(std::span<const Triangle> triangles,
                                      const std::vector<Vec3>& points);

}  // namespace kdm
