// SPDX-License-Identifier: MIT
// Where pieces of the surface touch in a point of a cell, not along a line through it.
#pragma once

#include <vector>

#include "split/cell_surface.h"

namespace kdm {

/// Searches cells for contact points. One object serves cell after cell.
class ContactPoints {
 public:
  explicit ContactPoints(const Surface& surface);

  /// Tells whether pieces that bound the solid touch in the cell, and their planes have a corner:
  /// they do not all run along one line. Pieces touch if they share a mesh vertex in the cell, or
  /// if `shells_touch` and nothing lies within the solid as it does where they cross, or coincide.
  bool exist_in(const CellSurface& cell, bool shells_touch);

 private:
  static bool nothing_is_inner(const CellSurface& cell);
  bool pieces_share_a_vertex(const CellSurface& cell);
  bool planes_have_a_corner(const CellSurface& cell) const;

  const Surface& surface_;
  std::vector<PieceId> piece_at_;    // per point: a piece that has it in the cell at hand
  std::vector<PointId> points_met_;  // of the cell at hand
};

}  // namespace kdm
