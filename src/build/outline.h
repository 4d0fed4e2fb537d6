// SPDX-License-Identifier: MIT
// The hits round a minimal face, in cyclic order, and how well two of them fit each other.
#pragma once

#include <vector>

#include "grid/faces.h"

namespace kdm {

/// A hit on the outline of a face.
struct OutlineHit {
  Index half_edge;
  Index hit;
  int side;
  bool starts_below;
  bool ascending;  // the outline runs up the grid edge here
};

inline OutlineHit outline_hit(const GridData& grid, const FaceEdge& edge, Index hit, int side) {
  return {3 * hit + edge.slot, hit, side, starts_below(edge, grid.hits[hit].reversed()),
          side == 0 || side == 1};
}

/// Counter-clockwise: sides 0 and 1 upwards, sides 2 and 3 downwards.
inline void collect_outline(const GridData& grid, const MinimalFace& face,
                            std::vector<OutlineHit>& outline) {
  outline.clear();
  for (int side = 0; side < 4; ++side) {
    const FaceEdge& edge = face.edges[side];
    for (Index i = 0; i < edge.size(); ++i) {
      const Index hit = side < 2 ? edge.begin + i : edge.end - 1 - i;
      outline.push_back(outline_hit(grid, edge, hit, side));
    }
  }
}

/// The surface's tangent line at a hit, on the face.
struct Tangent {
  double u, v;    // the hit's point on the face
  double nu, nv;  // unit normal of its tangent line there, or zero
};

void find_tangents(const GridData& grid, const MinimalFace& face,
                   const std::vector<OutlineHit>& outline, std::vector<Tangent>& tangents);

/// How far each of two hits lies from the other's tangent line, squared; a little of their
/// distance decides between pairings that fit equally well.
double deviation(const Tangent& a, const Tangent& b);

}  // namespace kdm
