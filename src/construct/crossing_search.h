// SPDX-License-Identifier: MIT
// Finds the crossings of the input's triangles with the four splitting edges of a split (paper
// 5.1.1).
#pragma once

#include <array>
#include <vector>

#include "inside/crossing.h"
#include "split/split_rules.h"
#include "split/triangle_lists.h"

namespace kdm {

/// Finds which triangles cross the edges of a splitting face, and where. Decides exactly which
/// triangles cross an edge and between which lattice planes they do; only the position between
/// these planes is rounded (geometry/predicates.h).
class CrossingSearch {
 public:
  explicit CrossingSearch(const std::vector<LatticeTriangle>& triangles) : triangles_(triangles) {}

  /// Searches the four splitting edges that the split adds to the cell with this box. `lists` must
  /// just have divided the triangles of this cell; only triangles that reach both sides of the
  /// splitting plane are tested.
  void run(const LatticeBox& box, const Split& split, const TriangleLists& lists);

  /// Returns the crossings found on splitting edge `i` (0 to 3), in no particular order. They may
  /// be sorted in place.
  std::vector<Crossing>& on_edge(int i) { return found_[static_cast<std::size_t>(i)]; }

 private:
  void test(TriangleId triangle, int axis, std::int32_t p, std::int32_t q, const LatticeBox& box,
            std::vector<Crossing>& found) const;

  const std::vector<LatticeTriangle>& triangles_;
  std::array<std::vector<Crossing>, 4> found_;
};

}  // namespace kdm
