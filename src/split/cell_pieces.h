// SPDX-License-Identifier: MIT
// The connected pieces of the surface within a cell, and whether each of them is a disk.
//
// The surface within an open cell is a union of mesh vertices, open mesh edges and open triangles,
// each cut to a convex set. So its Euler characteristic is the number of vertices minus edges plus
// triangles that meet the cell: exact counts, no arithmetic on coordinates. A piece that is a disk
// adds one to it and any other piece less, but for a closed sphere. A closed piece is known by its
// lack of crossings with the cell's edges.
//
// The rim of a sheet is left out of the sum, so that a half-disk, whose outline runs partly along
// the rim, counts as a disk. The rim is counted by itself: its connected parts in the cell are as
// many as its edges minus its vertices there, and a piece may have one of them.
#pragma once

#include <span>
#include <vector>

#include "split/cell_crossings.h"
#include "split/cell_triangles.h"
#include "split/member_groups.h"
#include "split/vertex_counter.h"

namespace kdm {

/// A connected part of the surface within the cell.
struct Piece {
  MemberId lowest_member = 0;
  Index crossings = 0;    ///< with the cell's edges
  Index kept = 0;         ///< of these the ones that will be hits
  Index inner = 0;        ///< of these the ones that are known to bound nothing
  LatticeBox bounds;      ///< rounded outwards
  int rims = 0;           ///< connected parts of the surface's rim in it
  bool is_inner = false;  ///< it is known to bound nothing in the cell
  unsigned edges = 0;     ///< bit e is set if the piece crosses edge e of the cell

  /// Tells whether all of the piece's crossings lie on one edge of the cell.
  bool hangs_on_one_edge() const { return edges != 0 && (edges & (edges - 1)) == 0; }
  /// Tells whether the piece bounds nothing as far as its crossings show.
  bool seems_inner() const { return crossings > 0 && inner == crossings; }
};

/// The pieces of one cell. One object serves cell after cell.
class CellPieces {
 public:
  explicit CellPieces(const Surface& surface) : vertices_(surface) {}

  /// Replaces the pieces by those that the members of a cell form.
  void find(const CellTriangles& triangles, const CellCrossings& crossings);

  std::span<const Piece> all() const { return pieces_; }
  PieceId piece_of(MemberId member) const { return piece_of_[member]; }
  /// Returns the sides on the surface's rim that meet the cell.
  std::span<const SideId> rim_sides() const { return groups_.rim_sides(); }
  /// Tells whether every piece that bounds the solid is a disk or half-disk that reaches the cell's
  /// edges.
  bool are_disks() const;
  /// Notes of a piece that it bounds nothing in the cell.
  void set_inner(PieceId piece) { pieces_[piece].is_inner = true; }
  bool some_are_inner() const { return bounding_ != pieces_.size(); }
  /// Counts again without the pieces that bound nothing; to be called after the last `set_inner`.
  void leave_inner_out(const CellTriangles& triangles);

 private:
  void count(const CellTriangles& triangles);

  VertexCounter vertices_;
  MemberGroups groups_;
  std::vector<MemberId> all_members_;  // that are counted
  std::vector<PieceId> piece_of_;      // per member
  std::vector<Piece> pieces_;
  std::int64_t euler_characteristic_ = 0;  // of the pieces that bound the solid
  Index bounding_ = 0;                     // how many these are
};

}  // namespace kdm
