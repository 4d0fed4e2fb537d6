// SPDX-License-Identifier: MIT
// Whether the surface crosses itself within a cell.
#pragma once

#include <cstdint>
#include <vector>

#include "split/cell_triangles.h"

namespace kdm {

/// Searches a cell for two triangles that cross. One object serves cell after cell.
class CrossingTriangles {
 public:
  /// Tells whether two members cross or touch within the cell. Where neighbours share an edge or a
  /// corner, that does not count. Takes a sweep along the longest axis of the cell, or a box tree
  /// where members are many.
  bool exist_in(const CellTriangles& triangles);

 private:
  std::vector<std::uint64_t> by_lower_bound_;  // along the axis of the sweep, with the member
};

}  // namespace kdm
