// SPDX-License-Identifier: MIT
// The outline of a minimal face: its hits in cyclic order, each with the half-edge across the face.
#pragma once

#include <vector>

#include "grid/faces.h"

namespace kdm {

/// A hit on the outline of a minimal face.
struct OutlineHit {
  HalfEdgeId half_edge;  ///< the one of the hit's three that crosses the face
  HitId hit;
  int side;           ///< of the face, 0 to 3 as splitting edges are numbered
  bool starts_below;  ///< does the half-edge start in the leaf below the face?
  bool ascending;     ///< does the outline run up the grid edge here?
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

/// Do the half-edges run against each other, so that they may be linked?
inline bool compatible(const OutlineHit& a, const OutlineHit& b) {
  return a.starts_below != b.starts_below;
}

}  // namespace kdm
