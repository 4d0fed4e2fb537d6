// SPDX-License-Identifier: MIT
// Lists the outline of a minimal face: its hits in cyclic order, each with its half-edge that
// crosses the face.
#pragma once

#include <vector>

#include "grid/faces.h"

namespace kdm {

/// A hit on the outline of a minimal face.
struct OutlineHit {
  HalfEdgeId half_edge;  ///< the one of the hit's three that crosses the face
  HitId hit;
  int side;           ///< of the face, 0 to 3 as splitting edges are numbered
  bool starts_below;  ///< whether the half-edge starts in the leaf below the face
  bool ascending;  ///< whether the outline, followed in cyclic order, runs up the hit's grid edge
};

/// Collects the hits round the face, counter-clockwise.
inline void collect_outline(const GridData& grid, const MinimalFace& face,
                            std::vector<OutlineHit>& outline) {
  outline.clear();
  for_each_hit(face, [&](const FaceEdge& edge, HitId hit, int side) {
    outline.push_back({3 * hit + edge.slot, hit, side,
                       starts_below(edge, grid.hits[hit].reversed()), side == 0 || side == 1});
  });
}

/// Returns whether the half-edges cross the face in opposite directions, so that they may be
/// linked.
inline bool compatible(const OutlineHit& a, const OutlineHit& b) {
  return a.starts_below != b.starts_below;
}

}  // namespace kdm
