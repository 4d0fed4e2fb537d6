// SPDX-License-Identifier: MIT
// Which part of a segment lies in a box, with an answer only where rounding cannot change it.
#pragma once

#include <array>
#include <optional>

#include "geometry/lattice.h"

namespace kdm {

/// A segment as a box sees it.
struct SegmentInBox {
  bool meets = false;              ///< some of it lies in the open box
  std::array<bool, 2> ends_in{};   ///< whether its ends do
  std::array<int, 2> leaves_by{};  ///< beyond an end that does not: 2 * axis + (1: the high side)
                                   ///< of the face that the segment leaves the box by
  std::array<Vec3, 2> ends{};      ///< of the part in the box
};

/// Finds the part of the segment from a to b, in lattice units, that lies in the box. The box is
/// read as shifted upwards by some millionths of a lattice unit, along each axis by another length,
/// as grid points are in predicates.h. Returns nothing if an end, or a point where the segment
/// passes from face to face of the box, is nearer to where the answer changes than `kUnsure`.
std::optional<SegmentInBox> segment_in_box(const Vec3& a, const Vec3& b, const LatticeBox& box);

/// In lattice units. Coordinates that are computed from products of lattice coordinates are off by
/// less.
inline constexpr double kUnsure = 1e-8;

}  // namespace kdm
