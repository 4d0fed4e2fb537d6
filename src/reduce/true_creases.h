// SPDX-License-Identifier: MIT
// Where the reference has creases.
#pragma once

#include <array>
#include <vector>

#include "reduce/cell_bits.h"
#include "reduce/scaled_mesh.h"

namespace kdm {

/// The places of the edges at which two triangles of the reference turn by more than 15 degrees
/// against each other.
class TrueCreases {
 public:
  /// Points within `reach` of a crease are near to it, and some up to seven times as far.
  TrueCreases(const ScaledMesh& reference, double reach);

  /// Adds segments at which the surface has creases too: where its parts pass through each other.
  void add(std::vector<std::array<Vec3, 2>> segments);

  bool are_near(const Vec3& p) const { return cells_.test(p) || added_.test(p); }

 private:
  Box box_;
  double width_;
  CellBits cells_;
  CellBits added_;
};

}  // namespace kdm
