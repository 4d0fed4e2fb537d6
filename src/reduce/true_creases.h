// SPDX-License-Identifier: MIT
// Where the reference has creases.
#pragma once

#include <array>
#include <vector>

#include "reduce/cell_bits.h"
#include "reduce/reference.h"

namespace kdm {

/// The places of the edges at which two triangles of the reference turn by more than 15 degrees
/// against each other.
class TrueCreases {
 public:
  /// Points within `reach` of a crease are near to it, and some up to seven times as far.
  TrueCreases(const Reference& reference, double reach);

  bool are_near(const Vec3& p) const { return cells_.test(p); }

 private:
  CellBits cells_;
};

}  // namespace kdm
