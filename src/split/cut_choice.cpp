// SPDX-License-Identifier: MIT
#include "split/cut_choice.h"

#include <algorithm>
#include <bit>

namespace kdm {
namespace {

// Topology is not pursued in cells smaller than 1/8 of the tolerance: where the input is not
// embedded, splitting never resolves it.
constexpr double kTopologyFloor = 1.0 / 8;
// No split is made nearer to a side of its cell than 1/32 of the tolerance: loops that are nested
// in a leaf need vertices that differ in 32 bits, for which slabs of a few lattice units are too
// thin.
constexpr double kMinCutWidth = 1.0 / 32;
// But where the input is embedded, topology is pursued down to a few lattice units.
constexpr std::int32_t kFinestCutWidth = 4;
// Cells that are thinner than 1/128 of the tolerance are not cut across that axis for topology:
// where the input is not embedded a curve may stay closed however often it is cut.
constexpr double kThinWidth = 1.0 / 128;
// A bar is a piece with a closed curve on a face of the cell. It is cut along its axis if it
// reaches no further sideways than this many times the width of the curve. One that leans more
// leaves the plane of such a cut before it ends.
constexpr double kMaxBarLean = 2;

// Returns a region whose middle planes open a closed curve, or nothing if the piece of the curve
// leans out of all of them. A region's extent along an axis says how well a cut across it serves. A
// bar is so cut along its axis; cuts across would leave slices as thick as they are wide.
std::optional<LatticeBox> region_to_open(const ClosedCurve& curve, const CellPieces& pieces) {
  const LatticeBox& piece = pieces.all()[curve.piece].bounds;
  LatticeBox region = curve.section;
  region.hi[curve.axis] = region.lo[curve.axis];  // never in the plane of the face itself
  if (pieces.are_disks()) return region;
  bool upright = false;
  for (const int axis : {next_axis(curve.axis), previous_axis(curve.axis)}) {
    if (extent(piece, axis) > kMaxBarLean * extent(curve.section, axis)) {
      region.hi[axis] = region.lo[axis];
    } else {
      upright = true;
    }
  }
  return upright ? std::optional(region) : std::nullopt;
}

// Returns the bounds of a pillow's piece along the edge that it hangs on, without extent along the
// other axes: the part needs crossings on an edge of another direction.
LatticeBox region_of_pillow(const Piece& piece) {
  const int along = std::countr_zero(piece.edges) / 4;
  LatticeBox region = piece.bounds;
  for (const int axis : {next_axis(along), previous_axis(along)}) region.hi[axis] = region.lo[axis];
  return region;
}

}  // namespace

CutChoice::CutChoice(const Surface& surface, double tolerance, int max_depth, CutPosition position)
    : surface_(surface),
      open_surface_(has_open_sides(surface)),
      tolerance_(tolerance),
      topology_floor_(std::max(kTopologyFloor * tolerance, 1.0)),
      min_cut_width_(static_cast<std::int32_t>(
          std::clamp(kMinCutWidth * tolerance, 1.0, static_cast<double>(kLatticeSize)))),
      thin_width_(kThinWidth * tolerance),
      max_depth_(max_depth),
      position_(position),
      features_(surface) {}

std::optional<Split> CutChoice::split_for_fit(const CellView& cell) {
  if (cell.depth >= max_depth_) return std::nullopt;
  if (position_ == CutPosition::kInTurn) return midpoint_in_turn(cell.box, cell.depth);
  if (position_ == CutPosition::kFeature) {
    if (const std::optional<Split> split = features_.propose(cell.box, cell.entries)) return split;
  }
  return halve_longest(cell, min_cut_width_);
}

std::optional<Split> CutChoice::split_for_topology(const CellView& cell,
                                                   const CellSurface& surface_in_cell,
                                                   const TopologyFault& fault,
                                                   const std::optional<Split>& between_parts,
                                                   TopologyFloor floor) {
  const bool fine = floor == TopologyFloor::kAtLattice;
  const std::int32_t min_width = fine ? kFinestCutWidth : min_cut_width_;
  if (between_parts && cell.depth < max_depth_ && has_room(cell.box, *between_parts, min_width)) {
    return between_parts;
  }
  const LatticeBox region = region_of(surface_in_cell, fault);
  const int axis = longest_axis(region);
  // A spike of an open surface has two rims at any size: it would be followed to its tip.
  if (surface_.has_rims() && extent(region, axis) < topology_floor_) return std::nullopt;
  if (position_ == CutPosition::kInTurn) return split_for_fit(cell);
  if (!fine && extent(cell.box, axis) < thin_width_) return halve_longest(cell, min_width);
  return split_at(cell, axis, region.lo[axis] + extent(region, axis) / 2, min_width);
}

// At the rim of a surface that is to be closed, what closes it may lie as far off as the tolerance,
// so the floor is the tolerance there.
bool CutChoice::is_below_topology_floor(const CellSurface& surface_in_cell) const {
  const LatticeBox& box = surface_in_cell.triangles.cell();
  const bool at_rim = surface_.repair && !surface_in_cell.pieces.rim_sides().empty();
  return extent(box, longest_axis(box)) < (at_rim ? tolerance_ : topology_floor_);
}

std::optional<Split> CutChoice::halve_longest(const CellView& cell, std::int32_t min_width) const {
  const int axis = longest_axis(cell.box);
  return split_at(cell, axis, cell.box.lo[axis] + extent(cell.box, axis) / 2, min_width);
}

// Splits across the axis, or across the longest one if the cell is too thin, as near to the value
// as the least width of cuts allows.
std::optional<Split> CutChoice::split_at(const CellView& cell, int axis, std::int32_t value,
                                         std::int32_t min_width) const {
  if (cell.depth >= max_depth_) return std::nullopt;
  const LatticeBox& box = cell.box;
  if (extent(box, axis) < 2 * min_width) {
    axis = longest_axis(box);
    if (extent(box, axis) < 2 * min_width) return std::nullopt;
  }
  return Split{axis, std::clamp(value, box.lo[axis] + min_width, box.hi[axis] - min_width)};
}

bool CutChoice::has_room(const LatticeBox& box, const Split& split, std::int32_t min_width) {
  return split.value - box.lo[split.axis] >= min_width &&
         box.hi[split.axis] - split.value >= min_width;
}

// Returns the box through whose middle, across its longest axis, the cell is split.
LatticeBox CutChoice::region_of(const CellSurface& surface_in_cell,
                                const TopologyFault& fault) const {
  if (const auto* pillow = std::get_if<Pillow>(&fault)) {
    return region_of_pillow(surface_in_cell.pieces.all()[pillow->piece]);
  }
  if (const auto* curve = std::get_if<ClosedCurve>(&fault)) {
    if (const auto region = region_to_open(*curve, surface_in_cell.pieces)) return *region;
  }
  return region_without_disks(surface_in_cell);
}

// Returns the bounds of a piece that no edge of the cell meets, or that lies between two rims; if
// there is none, of all pieces, or the whole cell of an open surface.
LatticeBox CutChoice::region_without_disks(const CellSurface& surface_in_cell) const {
  const std::span<const Piece> pieces = surface_in_cell.pieces.all();
  for (const Piece& piece : pieces) {
    if (piece.crossings == 0 || piece.rims > 1) return piece.bounds;
  }
  if (open_surface_) return surface_in_cell.triangles.cell();
  LatticeBox bounds = pieces.front().bounds;
  for (const Piece& piece : pieces) widen(bounds, piece.bounds);
  return bounds;
}

}  // namespace kdm
