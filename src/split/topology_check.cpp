// SPDX-License-Identifier: MIT
#include "split/topology_check.h"

#include <algorithm>

namespace kdm {

std::optional<TopologyFault> TopologyCheck::find_fault(const CellSurface& cell) {
  const std::span<const Piece> pieces = cell.pieces.all();
  if (std::all_of(pieces.begin(), pieces.end(), [](const Piece& p) { return p.is_inner; })) {
    return std::nullopt;
  }
  const bool disks = cell.pieces.are_disks();
  // A closed curve says best where to cut. On open surfaces curves may end on the rim of a piece
  // that is no half-disk; then the piece is the fault.
  if (disks || !open_surface_) {
    one_way_.find(cell);
    if (const std::optional<ClosedCurve> curve = sections_.find_closed_curve(cell, one_way_)) {
      return *curve;
    }
  }
  if (!disks) return NoDisk{};
  if (const std::optional<PieceId> piece = pillows_.find_pillow(cell)) return Pillow{*piece};
  return std::nullopt;
}

}  // namespace kdm
