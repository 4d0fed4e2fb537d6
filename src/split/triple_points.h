// SPDX-License-Identifier: MIT
// Points in a cell where three pieces of the surface cross.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "split/cell_states.h"
#include "split/cell_surface.h"
#include "split/crossing_triangles.h"

namespace kdm {

/// A point where members of three pieces cross.
struct TriplePoint {
  std::array<PieceId, 3> pieces;    ///< ascending
  std::array<MemberId, 3> members;  ///< of these pieces
  Vec3 point;                       ///< in lattice units
};

/// A part of the line along which two members cross.
struct CrossingSegment {
  std::array<PieceId, 2> pieces;  ///< ascending
  CrossingPair members;           ///< of these pieces
  std::array<Vec3, 2> ends;       ///< in lattice units
};

/// Finds triple points of cell after cell.
class TriplePoints {
 public:
  explicit TriplePoints(const CellStates& states) : states_(states) {}

  /// Takes up a cell. `pairs` holds all pairs of members that cross or touch in it.
  void start(const CellSurface& cell, std::span<const CrossingPair> pairs);
  /// Finds the triple points on a segment and appends them to `found`. Returns false if there may
  /// be others, because a third member passes the segment, or an edge or an end of it lies in its
  /// way, within a lattice unit.
  bool find(const CrossingSegment& segment, std::vector<TriplePoint>& found) const;
  /// Tells whether the solid's boundary about a triple point is one disk, or nothing. It is if what
  /// lies inside of the eight parts between the three pieces hangs together across faces, and so
  /// does what lies outside. The states must have been started in the cell. Where other members are
  /// within a lattice unit, the answer is no.
  bool bounds_a_disk(const TriplePoint& point) const;

 private:
  const CellStates& states_;
  const CellSurface* cell_ = nullptr;
  std::vector<CrossingPair> crossed_by_;  // all pairs both ways, ascending
};

/// Tells whether no member but the given ones, and those that continue them in their planes, is
/// within a lattice unit of the point.
bool only_these_are_near(const CellTriangles& members, std::span<const MemberId> these,
                         const Vec3& point);

}  // namespace kdm
