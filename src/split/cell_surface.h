// SPDX-License-Identifier: MIT
// What is known of the surface within the cell that may be split.
#pragma once

#include <vector>

#include "split/cell_crossings.h"
#include "split/cell_pieces.h"
#include "split/cell_triangles.h"

namespace kdm {

/// Where a triangle's part in the cell bounds nothing (see inner_triangles.h).
struct InnerPart {
  unsigned corners = 0;  ///< bit i is set if it bounds nothing at corner i of `clip_to_box`
  bool all = false;      ///< it bounds nothing at all points that were looked at
};

/// The part of the surface that lies in one cell. One object serves cell after cell; for each of
/// them the crossings are collected first, and the pieces are found if somebody needs them.
struct CellSurface {
  CellCrossings crossings;
  CellTriangles triangles;
  CellPieces pieces;
  std::vector<InnerPart> inner;  ///< per member; empty if nobody looked

  explicit CellSurface(const Surface& surface) : triangles(surface), pieces(surface) {}

  /// Finds the triangles that meet the cell and the pieces that they form. The cell's crossings
  /// must have been collected.
  void find_pieces(const LatticeBox& cell, std::span<const ListEntry> entries) {
    inner.clear();
    triangles.find(cell, entries);
    pieces.find(triangles, crossings);
  }

  /// Tells whether the member is known to bound nothing in the cell.
  bool is_inner(MemberId member) const {
    return pieces.all()[pieces.piece_of(member)].is_inner || (!inner.empty() && inner[member].all);
  }
  /// Tells whether the member is known to bound nothing at a corner of its part in the cell.
  bool is_inner_at(MemberId member, int corner) const {
    return is_inner(member) || (!inner.empty() && (inner[member].corners >> corner & 1) != 0);
  }
  /// Returns the piece of a triangle, kNone if the triangle does not meet the cell.
  PieceId piece_of_triangle(TriangleId triangle) const {
    const MemberId member = triangles.member_of(triangle);
    return member == kNone ? kNone : pieces.piece_of(member);
  }
  /// Returns the piece that a side on the surface's rim is of. The side must meet the cell.
  PieceId piece_of_rim(SideId side) const {
    return pieces.piece_of(triangles.member_of(triangle_of(side)));
  }
  /// Tells whether two pieces at least reach the rim of the surface in this cell.
  bool several_pieces_have_rims() const;
};

/// Tells whether some triangle of the surface has a side without opposite.
bool has_open_sides(const Surface& surface);

}  // namespace kdm
