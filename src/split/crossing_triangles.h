// SPDX-License-Identifier: MIT
// Whether the surface crosses itself within a cell.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "mesh/marks.h"
#include "split/cell_triangles.h"

namespace kdm {

/// Two members that cross or touch.
using CrossingPair = std::array<MemberId, 2>;

/// Searches a cell for two triangles that cross. One object serves cell after cell.
class CrossingTriangles {
 public:
  /// Tells whether two members cross or touch within the cell. Where neighbours share an edge or a
  /// corner, that does not count. Takes a sweep along the longest axis of the cell, or a box tree
  /// where members are many.
  bool exist_in(const CellTriangles& triangles);

  /// Finds every member that crosses or touches another one within the cell, in the same way.
  /// Returns marks per member.
  const Marks& find_all(const CellTriangles& triangles);

  /// Finds all pairs of members that cross or touch within the cell, in the same way.
  std::span<const CrossingPair> find_pairs(const CellTriangles& triangles);

 private:
  template <typename Skips, typename Visit>
  void for_each_crossing(const CellTriangles& triangles, const Skips& skips, const Visit& visit);

  Marks crossing_;
  std::vector<CrossingPair> pairs_;
  std::vector<std::uint64_t> by_lower_bound_;  // along the axis of the sweep, with the member
};

}  // namespace kdm
