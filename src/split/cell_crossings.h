// SPDX-License-Identifier: MIT
// The crossings on the twelve edges of one cell.
#pragma once

#include <array>
#include <vector>

#include "geometry/predicates.h"
#include "split/split_rules.h"

namespace kdm {

/// A crossing on one of the cell's edges.
struct CellCrossing {
  LinePosition position;  ///< along the edge
  TriangleId triangle;
  int edge;    ///< which of the cell's twelve, numbered as `cell_edge` does
  bool kept;   ///< the crossing bounds the solid: it will be a hit
  bool inner;  ///< it does not, and what is known of it says so: parts do not merely touch there
};

/// The crossings on a cell's edges, edge after edge, and how many of them lie around each face.
struct CellCrossings {
  std::vector<CellCrossing> all;
  std::array<std::array<Index, 2>, 3> around_face{};  ///< by the face's axis; 0: low side, 1: high
  Index kept = 0;
  bool has_gaps = false;     ///< some of the crossings bound gaps that are closed
  bool has_touches = false;  ///< at some of the crossings parts of the solid touch

  /// Replaces the contents by the crossings of the given cell.
  void collect(const CellView& cell);
  /// Tells whether some crossings will not be hits. This happens where shells cross and where one
  /// lies within another.
  bool some_dropped() const { return kept < all.size(); }
  /// Tells whether one curve in which a surface without rims meets the cell's sides passes through
  /// all crossings. An answer "no" promises nothing: it is given too where a side has more than two
  /// crossings, so that several curves might pass there.
  bool form_one_loop() const;
};

/// Returns the point of a crossing on an edge of the box, in lattice units.
Vec3 crossing_point(const CellCrossing& crossing, const LatticeBox& box);

/// Tells whether an edge of a cell belongs to the outline of the face normal to `axis` at the
/// cell's low or high side.
bool edge_bounds_face(int edge, int axis, bool high);

}  // namespace kdm
