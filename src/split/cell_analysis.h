// SPDX-License-Identifier: MIT
// What the surface within a cell is: its pieces, their topology, exactly (Euler characteristic and
// connectedness by counting, with the predicates of geometry/).
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "grid/grid_data.h"
#include "prepare/surface.h"
#include "split/triangle_lists.h"

namespace kdm {

/// Makes the box hold another one.
inline void widen(LatticeBox& bounds, const LatticeBox& by) {
  for (int i = 0; i < 3; ++i) {
    bounds.lo[i] = std::min(bounds.lo[i], by.lo[i]);
    bounds.hi[i] = std::max(bounds.hi[i], by.hi[i]);
  }
}

/// A crossing on one of the cell's edges.
struct CellCrossing {
  Index triangle;
  int edge;   ///< of the cell's twelve
  bool kept;  ///< the inside rule changes there: it will be a hit
};

/// The cell's crossings, and how many lie round each of its faces (axis, low/high).
struct CellCrossings {
  std::vector<CellCrossing> all;
  std::array<std::array<Index, 2>, 3> round_face{};
};

/// A connected part of the surface within the cell.
struct Piece {
  Index crossings = 0;
  Index kept = 0;
  LatticeBox bounds;
  int rims = 0;        ///< connected parts of the rim in it
  unsigned edges = 0;  ///< a bit for each of the cell's edges that it crosses

  bool hangs_on_one_edge() const { return edges != 0 && (edges & (edges - 1)) == 0; }
};

/// The surface's section with a face of the cell has a closed curve (paper fig. 8a), or one from
/// rim to rim.
struct ClosedCurve {
  int axis;           ///< normal to the face
  LatticeBox bounds;  ///< of the curve; of all triangles on the face where it is none by itself
  Index piece;        ///< that the curve is of, or one of those
};

class CellAnalysis {
 public:
  explicit CellAnalysis(const Surface& surface);

  /// Finds the triangles that meet the cell and the pieces they form. `crossings` must live on.
  void find_pieces(const LatticeBox& box, std::span<const ListEntry> entries,
                   const CellCrossings& crossings);

  std::span<const Piece> pieces() const { return pieces_; }
  /// The triangles that meet the cell, and the piece of each.
  std::span<const Index> members() const { return members_; }
  Index piece_of(std::size_t member) const { return piece_[member]; }
  /// Bounds of a member's part in the cell, rounded outwards.
  const LatticeBox& bounds_of(std::size_t member) const { return bounds_[member]; }
  /// Piece of a triangle, kNone if it does not meet the cell.
  Index piece_of_triangle(Index triangle) const {
    return local_[triangle] == kNone ? kNone : piece_[local_[triangle]];
  }

  /// The sides on the rim of a sheet that meet the cell.
  std::span<const Index> rims() const { return cell_rims_; }

  /// Is every piece a disk that reaches the cell's edges, or a half-disk?
  bool pieces_are_disks() const;
  /// The first face of the cell with a closed curve, if there is one.
  std::optional<ClosedCurve> find_closed_curve();
  /// A piece that hangs on one edge of the cell and is of a closed part no larger than the cells
  /// round that edge, if there is one: it would come out without volume.
  std::optional<Index> find_pillow();
  /// Do two triangles cross or touch within the cell, but for what neighbours share?
  bool triangles_cross();

 private:
  Index count_parts(std::span<const Index> subset, const LatticeBox& box);
  Index find(Index i);
  bool part_is_near(Index triangle);
  bool members_cross(Index i, Index j) const;
  bool part_ends_in_two_rims();
  ClosedCurve closed_curve(int axis, bool high);
  LatticeBox section_bounds(Index part, int axis, std::int32_t plane);

  const Surface& surface_;
  LatticeBox box_;
  const CellCrossings* crossings_ = nullptr;
  std::vector<Index> members_;
  std::vector<LatticeBox> bounds_;  // per member: of its part in the cell, rounded outwards
  std::vector<Index> piece_;        // per member
  std::vector<Index> local_;        // per triangle: its number among the members, or kNone
  std::vector<char> on_rim_;        // per point of a sheet
  std::vector<Index> rim_sides_;    // of the last count_parts: rim sides that meet the box
  std::vector<Index> cell_rims_;
  std::vector<Index> subset_;
  std::vector<Index> parent_;
  std::vector<char> ended_;   // per member that leads a part of a section: has an end
  std::vector<Index> visit_;  // per triangle: the last search that came by
  Index visits_ = 0;
  std::vector<Index> stack_;
  std::vector<Index> counted_;  // per point: the last cell that counted it
  Index counts_ = 0;
  std::vector<std::pair<std::int32_t, Index>> by_bound_;  // members and where they begin
  std::vector<Piece> pieces_;
  Index edges_ = 0;
  std::int64_t euler_characteristic_ = 0;
};

}  // namespace kdm
