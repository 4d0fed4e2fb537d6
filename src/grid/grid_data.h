// SPDX-License-Identifier: MIT
// Keeps the kd-tree grid as flat arrays (paper 3.2), and defines the numbering that the rest of the
// code refers to.
//
// Cells. Split k cuts one cell in two and makes cells 2k+1 (below) and 2k+2 (above); cell 0 is the
// root. A split along axis w adds a splitting face, the rectangle that the plane has in common with
// the cell. With u and v the axes after w (u = w+1, v = w+2, cyclically), its four splitting edges
// are 4k+i, i counting round the face, counter-clockwise as seen from above:
//
// clang-format off
//
//      v                  2 (top)
//      ^             +---------------+
//      |             |               |
//      |    3 (left) |       w       | 1 (right)       w points at the reader
//      |             |               |
//      |             +---------------+
//      |                 0 (bottom)
//      +-------------------------------> u
//
// clang-format on
//
// Every grid edge is part of exactly one splitting edge or of an edge of the root, which is never
// hit. The hits of an edge are consecutive and ascend along it.
//
// Strips. Where two cells beside each other are split at the same value, two splitting edges
// coincide, one from either side of the plane between the cells. The split below that plane counts
// as lying infinitely little below the one above it; so a minimal face without width, a strip, lies
// between the two edges, whose hits are the same and are linked one to one across it (see faces.h).
//
// Half-edges. Around hit h lie three leaves: one in each child of its split, V0 and V1, and one
// beyond the side plane, VN. The hit is a triangle of these three, and its half-edges cross
//   slot 0 (3h):   the splitting face, between V0 and V1
//   slot 1 (3h+1): the face between V0 and VN
//   slot 2 (3h+2): the face between V1 and VN.
// The triangle runs V0 V1 VN, or V0 VN V1 if the hit is `reversed`.
#pragma once

#include <memory>
#include <vector>

#include "geometry/lattice.h"
#include "geometry/plane.h"
#include "geometry/predicates.h"
#include "grid/hit_range.h"
#include "kdmanifold/build.h"
#include "kdmanifold/grid.h"
#include "kdmanifold/mesh.h"

namespace kdm {

/// The greatest depth of a leaf. Where each split halves a cell, cells of this depth are one
/// lattice unit wide. Recursions rely on the limit.
inline constexpr int kMaxDepth = 3 * kLatticeBits;

/// A node of the kd-tree: 8 bytes.
class Cell {
 public:
  Cell() = default;  // a leaf
  Cell(CellId first_child, int axis, std::int32_t value)
      : first_child_(first_child),
        packed_(static_cast<std::uint32_t>(value) | static_cast<std::uint32_t>(axis) << 21) {}

  bool leaf() const { return first_child_ == 0; }
  /// Return the children below and above the splitting plane. This and the functions up to `value`
  /// must not be called for a leaf.
  CellId below() const { return first_child_; }
  CellId above() const { return first_child_ + 1; }
  SplitId split() const { return (first_child_ - 1) / 2; }
  /// The splitting plane is normal to `axis`, at coordinate `value` (lattice units).
  int axis() const { return static_cast<int>(packed_ >> 21 & 3u); }
  std::int32_t value() const { return static_cast<std::int32_t>(packed_ & 0x1fffffu); }

  /// Returns whether this side of the cell is active: a split within the cell has a splitting edge
  /// on the side that carries a hit. Leaves have no active sides.
  bool active(int axis, bool high) const { return (packed_ >> side_bit(axis, high) & 1u) != 0; }
  void set_active(int axis, bool high) { packed_ |= 1u << side_bit(axis, high); }
  void clear_active() { packed_ &= ~(63u << 23); }

 private:
  static constexpr int side_bit(int axis, bool high) { return 23 + 2 * axis + (high ? 1 : 0); }
  std::uint32_t first_child_ = 0;  // 0: leaf
  std::uint32_t packed_ = 0;       // 21 bits value, 2 bits axis, 6 bits active sides
};
static_assert(sizeof(Cell) == 8);

/// An intersection of the surface with a grid edge: 8 bytes.
struct Hit {
  LinePosition position;  ///< the coordinate along the edge
  std::uint32_t packed;   ///< 30 bits number of the plane, then the two flags

  Hit() = default;
  Hit(LinePosition where, PlaneId plane, bool leaving, bool reversed)
      : position(where), packed(plane | (reversed ? kReversed : 0u) | (leaving ? kLeaving : 0u)) {}

  PlaneId plane() const { return packed & kPlaneMask; }  ///< number in GridData::planes
  /// Returns whether the edge, followed upwards, leaves the solid at the hit. If so, the normal of
  /// the hit's plane points up along the edge.
  bool leaving() const { return (packed & kLeaving) != 0; }
  /// Returns whether the hit's triangle runs V0 VN V1 rather than V0 V1 VN (see the top of the
  /// file).
  bool reversed() const { return (packed & kReversed) != 0; }

  static constexpr std::uint32_t kLeaving = 1u << 31;
  static constexpr std::uint32_t kReversed = 1u << 30;
  static constexpr std::uint32_t kPlaneMask = kReversed - 1;
};
static_assert(sizeof(Hit) == 8);

/// The point where the rim of an open surface passes through a minimal face. The curve in which the
/// surface meets the face begins at a hit and ends at this point. On a sheet, the hit's half-edge
/// across the face lies on the boundary; on a solid, it is linked to a hit that was invented to
/// close the surface.
struct RimHit {
  HalfEdgeId half_edge;
  Vec3 point;   ///< on the face, lattice coordinates
  Vec3 normal;  ///< of the plane through the rim upright on the surface; zero if there is none
};

/// A corner of the surface in a leaf, kept for a loop of half-edges in the leaf. It cannot be found
/// from the planes of the loop's hits, as one of the faces that form the corner has no hit in the
/// loop.
struct KeptCorner {
  HalfEdgeId half_edge;  ///< of the loop's half-edges, the one with the lowest number
  Vec3 point;            ///< lattice coordinates
  /// `simplify` has joined loops here, and has tested the straight edges of the vertex: none of
  /// them gets another vertex or is flipped.
  bool joined = false;
};

/// Returns the number of splitting edge `i` (0 to 3) of a split.
constexpr EdgeId edge_of_split(SplitId split, int i) { return 4 * split + static_cast<EdgeId>(i); }

/// A grid: its cells, the hits on their edges and the links between the hits' half-edges.
struct GridData {
  Lattice lattice;
  double tolerance = 0;              ///< how far the result may be from the input, lattice units
  std::vector<Cell> cells;           ///< cell 0 is the root; 2 * splits() + 1 of them
  std::vector<HitId> edge_begin;     ///< per splitting edge its first hit; last, the number of hits
  std::vector<Hit> hits;             ///< edge by edge
  std::vector<HalfEdgeId> opposite;  ///< per half-edge the one it is linked to; kNone: boundary
  std::vector<std::uint32_t> start;  ///< per half-edge: see `start_leaf` and `crosses_strip`
  /// The planes of the input's faces with hits, lattice units, in the order of their first hits;
  /// normals point out of the solid.
  std::vector<Plane> planes;
  std::vector<Index> source_faces;  ///< per plane the number of its input face; kPatch: of a patch
                                    ///< that closes a hole; kNone: invented
  /// Of a Boolean operation, per plane the number of its operand; kNone: of the box round them all.
  /// Empty if the grid was built from one mesh.
  std::vector<Index> source_operands;
  /// Thin parts of the input that are no matter of cells and hits: the result has them as they are.
  /// Triangles only, in model units; coordinates are 32-bit floats.
  Mesh exact;
  bool sheet = false;  ///< it is the grid of a sheet: half-edges may lie on the boundary
  /// The inside rule and the option `thicken` that the grid was built with. Saved grids do not
  /// tell.
  InsideRule inside = InsideRule::kRepair;
  double thickness = 0;
  /// In model units: how far `simplify` may have moved the surface. Not 0: the corners that the
  /// grid keeps are the vertices of their loops, to the point.
  double simplified = 0;
  std::vector<RimHit> rims;  ///< ascending by half-edge; a half-edge on the boundary may have none
  std::vector<KeptCorner> corners;  ///< ascending by half-edge; a loop has one at most
  GridStats stats;
  InputReport input;
  std::vector<InputReport> operands;  ///< of a Boolean operation; `input` is their sum

  static constexpr std::uint32_t kStrip = 1u << 31;  ///< in `start`, beside the leaf
  /// Returns the leaf in which a half-edge starts.
  CellId start_leaf(HalfEdgeId half_edge) const { return start[half_edge] & ~kStrip; }
  /// Returns whether the minimal face that a half-edge crosses is a strip.
  bool crosses_strip(HalfEdgeId half_edge) const { return (start[half_edge] & kStrip) != 0; }
  HitRange edge_hits(EdgeId edge) const { return {edge_begin[edge], edge_begin[edge + 1]}; }
  /// Returns the hits of splitting edge `i` (0 to 3) of a split.
  HitRange edge_hits(SplitId split, int i) const { return edge_hits(edge_of_split(split, i)); }
  const Plane& plane_of(HitId hit) const { return planes[hits[hit].plane()]; }
  /// Returns whether the hit was invented to close a hole, so that its plane is neither that of an
  /// input face nor that of a patch.
  bool invented(HitId hit) const { return source_faces[hits[hit].plane()] == kNone; }
  Index splits() const { return static_cast<Index>(cells.size() / 2); }
  std::size_t bytes() const;
};

/// Returns the number (0 to 3) of the splitting edge of a split along `axis` that lies on the side
/// plane of its cell normal to `side_axis`, at the low or the high end.
constexpr int edge_on_side(int axis, int side_axis, bool high) {
  return next_axis(axis) == side_axis ? (high ? 1 : 3) : (high ? 2 : 0);
}

/// Returns the axis along which splitting edge `i` (0 to 3) of a split along `axis` runs.
constexpr int axis_of_edge(int axis, int i) {
  return i % 2 == 0 ? next_axis(axis) : previous_axis(axis);
}

/// Returns whether the triangle of a hit on splitting edge `i` (0 to 3) is reversed: it is if the
/// triangle V0 V1 VN has the wrong normal. The normal must point up the edge if the hit is leaving,
/// else down.
constexpr bool reversed_on_edge(int i, bool leaving) {
  // Edge 0 runs along u; V0 is at -w, V1 at +w and VN at -v: seen from +u that is
  // counter-clockwise. A quarter turn about w gives edge 1, along v. Edges 2 and 3 run against the
  // turn of the face.
  const bool counter_clockwise = i == 0 || i == 1;
  return counter_clockwise != leaving;
}

/// Returns the half-edge that follows in the triangle of its hit, given whether the hit is
/// reversed.
constexpr HalfEdgeId next_half_edge(HalfEdgeId half_edge, bool reversed) {
  const Index slot = half_edge % 3;
  const HalfEdgeId first = half_edge - slot;
  // V0 V1 VN has slots 0 2 1 in turn; V0 VN V1 has 1 2 0.
  return reversed ? first + (slot == 2 ? 0 : slot + 1) : first + (slot == 0 ? 2 : slot - 1);
}

/// Sets the active sides of all cells. No side may be active before. Linear in the cells.
void mark_active_sides(GridData& grid);

/// Computes the box of every cell, leaf or not.
std::vector<LatticeBox> cell_boxes(const GridData& grid);

}  // namespace kdm
