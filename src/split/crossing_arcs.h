// SPDX-License-Identifier: MIT
// Whether shells that cross in a cell bound disks there together.
//
// Two disks that cross along one arc, from one face of the cell to another, are each divided in two
// halves. Where the solid's boundary turns from one into the other, it takes one half of each, and
// the arc joins them to a disk. Three disks that cross in one point and each other along one arc
// each lie as three planes do, and may bound a disk about the point. Such disks may be joined to
// further ones in the same way, as long as they form no ring. On every face of the cell curves of
// two disks meet once at most, so the curves of the joined disk run from edge to edge of the cell,
// as those of a single disk do.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

#include "geometry/segment_box.h"
#include "mesh/disjoint_sets.h"
#include "split/cell_states.h"
#include "split/cell_surface.h"
#include "split/crossing_triangles.h"
#include "split/triple_points.h"

namespace kdm {

/// Looks at the curves along which pieces cross within a cell. One object serves cell after cell.
///
/// Which edge pierces which triangle is decided exactly, by signs of volumes. Ties, such as an edge
/// that meets an edge, are resolved by moving one of two pieces by an infinitely small step: once
/// there and once back, and only what holds in both cases counts. So nothing is claimed where faces
/// lie on each other back to back, or edges touch faces. Which sides of a curve lie inside follows
/// from states that are counted to a point beside it. Where anything is so near to something else
/// that rounding might change the answer, the answer is no.
class CrossingArcs {
 public:
  explicit CrossingArcs(const CellStates& states) : states_(states), triple_points_(states) {}

  enum class Answer {
    kDisks,    ///< the solid's boundary in the cell is a set of disks that reach the cell's edges
    kTooMuch,  ///< it would be in smaller cells
    kUnclear
  };

  /// Looks at the solid's boundary in the cell.
  /// The pieces that bound it must be disks without closed curves on the cell's faces, it must be
  /// known what is inner, and the states must have been started in the cell. `pairs` holds all
  /// pairs of members that cross or touch in it.
  Answer join_pieces_to_disks(const CellSurface& cell, std::span<const CrossingPair> pairs);

 private:
  using Pierced = std::uint64_t;  // a mesh edge and the member that it pierces

  // What two members have in common: a part of the line along which they cross.
  struct Segment {
    std::array<PieceId, 2> pieces;   // ascending
    CrossingPair members;            // of these pieces
    std::array<Pierced, 2> pierced;  // at the ends
    SegmentInBox part;               // within the cell
    Index triple = kNone;            // the triple point on it
  };
  // How the four sheets that meet at a curve bound the solid.
  enum class Sheets {
    kUnknown,
    kThrough,  // none does, or those of one piece do: the boundary does not turn
    kTurn,     // one of each piece
    kAll
  };
  // A curve along which two pieces cross.
  struct Curve {
    Sheets sheets = Sheets::kUnknown;
    unsigned faces = 0;  // of the cell, at which it ends: bit 2 * axis + (1: the high side)
    int ends = 0;
    Index triple = kNone;  // the triple point on it
  };
  // A curve with one triple point.
  struct DividedCurve {
    std::array<PieceId, 3> pieces;  // that cross at the point, ascending
    std::array<PieceId, 2> along;   // those that cross along the curve
    unsigned faces;                 // as of a curve
    Index triple;

    bool operator<(const DividedCurve& other) const {
      return std::tie(pieces, along) < std::tie(other.pieces, other.along);
    }
  };

  bool join_pieces(const CellSurface& cell, std::span<const CrossingPair> pairs, int step);
  bool add_segment(const CellSurface& cell, const CrossingPair& pair, int step);
  bool join_along_curves(const CellSurface& cell, std::span<const Segment> segments);
  bool join_along_curve(const CellSurface& cell, const std::array<PieceId, 2>& pieces,
                        const Curve& curve);
  bool join_at_triple_points();
  bool connect_segments(std::span<const Segment> segments, DisjointSets& connected);
  Sheets sheets_along(const CellTriangles& members, const Segment& segment) const;
  static bool is_partly_inner(const CellSurface& cell, PieceId piece);

  const CellStates& states_;
  bool clear_ = false;  // all that was seen of the cell at hand is certain
  std::vector<Segment> segments_;
  TriplePoints triple_points_;
  std::vector<TriplePoint> triples_;  // each once for every segment that it lies on
  std::vector<DividedCurve> divided_;
  std::vector<std::pair<Pierced, Index>> ends_;  // that lie in the cell, with their segments
  std::vector<Curve> curves_;                    // of two pieces; by their lowest segments
  std::optional<DisjointSets> joined_;           // the pieces
  std::vector<Index> turns_;                     // per piece: how many arcs it has
  std::vector<PieceId> guessed_;                 // that turn along a curve whose states are unknown
  std::vector<std::array<PieceId, 2>> flush_;    // pieces with faces on each other
  std::vector<PieceId> lowest_joined_;           // per piece, after the step there
};

}  // namespace kdm
