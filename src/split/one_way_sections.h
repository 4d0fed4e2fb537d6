// SPDX-License-Identifier: MIT
// Which sides of a cell the surface meets in curves that all run one way, so that none is closed.
//
// Let d be the direction that the cell's triangles face on the whole, N the normal of a triangle
// and e the normal of a side. The triangle meets the side's plane in a line along N x e. Where
// N . d' > 0 for all triangles there, d' being d without its part along e, all these lines run
// forwards along d' x e, since (N x e) . (d' x e) = N . d'. Neighbours face the same way; so no
// curve that they form comes back to where it began.
//
// Where all triangles of the cell face along d, and they are one disk whose outline crosses no side
// more than once, no two of them meet: all surface that a line along d meets it crosses from below,
// and as a disk with a simple outline divides the cell in two, it does so once.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "split/cell_surface.h"

namespace kdm {

/// Looks at the normals of a cell's triangles, exactly. One object serves cell after cell.
class OneWaySections {
 public:
  /// Looks at a cell, whose pieces must have been found. Finds nothing on surfaces with rims, whose
  /// triangles need not face the same way, nor in cells with very many triangles.
  void find(const CellSurface& cell);

  /// Tells whether all curves on the side normal to `axis`, at the cell's low or high end, run one
  /// way. An answer "no" promises nothing.
  bool run_one_way(int axis, bool high) const { return one_way_[axis][high ? 1 : 0]; }

  /// Tells whether the cell's surface is a single disk that some direction sees from one side only
  /// and at most once everywhere. Then no two triangles cross within the cell. An answer "no"
  /// promises nothing. The cell must be the one that was looked at last.
  bool are_of_a_graph(const CellSurface& cell) const;

 private:
  std::array<std::array<bool, 2>, 3> one_way_{};    // by the side's axis; 0: low side, 1: high
  bool all_face_along_ = false;                     // all triangles, the direction of the cell
  std::vector<std::array<std::int64_t, 3>> areas_;  // per member: its area vector
};

}  // namespace kdm
