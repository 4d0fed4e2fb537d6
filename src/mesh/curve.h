// SPDX-License-Identifier: MIT
// Places on a space-filling curve: what is near on it is near in space.
#pragma once

#include <array>
#include <cstdint>

namespace kdm {

/// Returns the place of a cell of a raster of 1024^3 on G. M. Morton's curve: every bit of it, from
/// bit 29 down, says which half of a cell the place lies in, along z, y and x in turn.
inline std::uint32_t place_on_curve(const std::array<std::uint32_t, 3>& cell) {
  std::uint32_t place = 0;
  for (int axis = 0; axis < 3; ++axis) {
    // Spreads the lowest ten bits so that two zeros follow each.
    std::uint32_t bits = cell[axis];
    bits = (bits | bits << 16) & 0x030000ffu;
    bits = (bits | bits << 8) & 0x0300f00fu;
    bits = (bits | bits << 4) & 0x030c30c3u;
    place |= ((bits | bits << 2) & 0x09249249u) << axis;
  }
  return place;
}

}  // namespace kdm
