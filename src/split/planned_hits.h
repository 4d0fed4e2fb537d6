// SPDX-License-Identifier: MIT
// The hits that a cell's edges would have if the cell stayed a leaf.
#pragma once

#include <span>
#include <vector>

#include "split/cell_surface.h"

namespace kdm {

/// Stands for all pieces of a cell that have hits, taken together.
inline constexpr PieceId kAllPieces = kNone;

/// A crossing that is kept.
struct PlannedHit {
  Vec3 point;          ///< lattice units
  const Plane* plane;  ///< of the triangle
  TriangleId triangle;
  PieceId piece = kNone;  ///< kNone until `assign_pieces`
};

/// The planned hits of one cell, and their planes. One object serves cell after cell.
class PlannedHits {
 public:
  /// Replaces the hits by those of another cell.
  void plan(const Surface& surface, const LatticeBox& box, const CellCrossings& crossings);
  /// Notes for each hit the piece that its triangle is of.
  void assign_pieces(const CellSurface& cell);

  std::span<const PlannedHit> all() const { return hits_; }
  bool empty() const { return hits_.empty(); }

  /// Calls `visit(hit)` for each hit of a piece, or for each hit for `kAllPieces`.
  template <typename Visit>
  void for_each_of(PieceId piece, const Visit& visit) const {
    for (const PlannedHit& hit : hits_) {
      if (is_of(hit, piece)) visit(hit);
    }
  }

  /// Tells whether the point lies within a distance of the plane of one of the piece's hits. Tries
  /// the plane that was met last before all others, since neighbouring points often meet the same.
  bool meets_a_plane(const Vec3& point, PieceId piece, double distance) {
    if (last_plane_met_ < hits_.size() && meets(last_plane_met_, point, piece, distance)) {
      return true;
    }
    return meets_another_plane(point, piece, distance);
  }
  /// Tells whether the plane of one of the piece's hits lies within a distance of the whole
  /// triangle. Makes it the plane that was met last.
  bool triangle_meets_a_plane(const LatticeTriangle& t, PieceId piece, double distance);

 private:
  bool meets(std::size_t i, const Vec3& point, PieceId piece, double distance) const {
    return is_of(hits_[i], piece) && hits_[i].plane->distance(point) <= distance;
  }
  bool meets_another_plane(const Vec3& point, PieceId piece, double distance);

  static bool is_of(const PlannedHit& hit, PieceId piece) {
    return piece == kAllPieces || hit.piece == piece;
  }

  std::vector<PlannedHit> hits_;
  std::size_t last_plane_met_ = 0;  // the number of a hit, maybe of another cell
};

}  // namespace kdm
