// SPDX-License-Identifier: MIT
#include "split/cell_surface.h"

#include <algorithm>

namespace kdm {

bool CellSurface::several_pieces_have_rims() const {
  const std::span<const SideId> sides = pieces.rim_sides();
  return std::any_of(sides.begin(), sides.end(), [&](SideId side) {
    return piece_of_rim(side) != piece_of_rim(sides.front());
  });
}

bool has_open_sides(const Surface& surface) {
  const std::vector<SideId>& opposites = surface.topology.opposite;
  return std::find(opposites.begin(), opposites.end(), kNone) != opposites.end();
}

}  // namespace kdm
