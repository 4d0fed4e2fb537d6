// SPDX-License-Identifier: MIT
// What the removal of one split does to the links and the loops of a grid.
//
// With the splitting face, all triangles of the hits on its four edges vanish. Each has a side
// across the splitting face, between loops of the two children, and two sides across the faces
// towards a third leaf. So the loops of the children that are joined by such triangles become one,
// and the rows of triangles between a child's loops and a loop beyond close up: what was linked to
// the two ends of a row becomes linked to each other.
#pragma once

#include <span>
#include <vector>

#include "simplify/work_grid.h"

namespace kdm {

/// A row of triangles that vanish, side by side round a vertex beyond the cell's side.
struct RemovedRow {
  Index piece;
  LoopId beyond;  ///< the loop of that vertex
  std::vector<HitId> hits;
  /// The half-edges that the outer sides of the row are linked to, kNone on the boundary, and these
  /// sides. They become linked to each other.
  std::array<HalfEdgeId, 2> ends;
  std::array<HalfEdgeId, 2> sides;
};

/// Loops of the two children that are joined by triangles that vanish.
struct JoinedPiece {
  std::vector<LoopId> loops;
  std::vector<HitId> gone;       ///< the hits of the triangles that vanish
  std::vector<HalfEdgeId> ring;  ///< of the loop that they become, once the links are changed
  Index links = 0;               ///< sides between the loops
  Index closed_rows = 0;         ///< rows that go all round a loop beyond, which vanishes
};

/// The removal of the split of a cell between two leaves.
class Removal {
 public:
  /// `work` must outlive this.
  explicit Removal(WorkGrid& work) : work_(work), local_(work.position.size(), kNone) {}

  /// Finds the rows and the pieces. Changes nothing.
  void look_at(CellId cell);
  /// Tells whether every piece is a disk, so that the surface keeps its topology.
  bool keeps_topology() const;

  std::span<const RemovedRow> rows() const { return rows_; }
  std::span<const JoinedPiece> pieces() const { return pieces_; }

  /// Changes the links, and finds the rings of the pieces. Tells whether each piece becomes one
  /// loop, and every ring that loses triangles keeps three, or one on the boundary; otherwise the
  /// links are as they were.
  bool try_links();
  /// Changes the links back.
  void undo_links();
  /// After `try_links`: removes the split. `positions` are the vertices of the pieces.
  void finish(std::span<const Vec3> positions);

 private:
  Index local_of(LoopId v);
  Index root_of(Index i) const;
  void find_pieces();
  void find_rows();
  void find_row(HalfEdgeId side);
  bool removed(HalfEdgeId h) const { return h / 3 >= first_ && h / 3 < beyond_; }
  bool find_rings();
  bool is_wide(HalfEdgeId start) const;

  WorkGrid& work_;
  CellId cell_ = 0;
  HitId first_ = 0;  // of the hits that vanish
  HitId beyond_ = 0;
  std::vector<RemovedRow> rows_;
  std::vector<JoinedPiece> pieces_;
  std::vector<Index> local_;   // per loop: its place among `loops_`
  std::vector<LoopId> loops_;  // of the two children, as far as triangles at them vanish
  std::vector<Index> up_;      // per place: union-find
  std::vector<Index> piece_;   // per place of a root
  Marks visited_;              // per hit from `first_` on: its row was found
};

}  // namespace kdm
