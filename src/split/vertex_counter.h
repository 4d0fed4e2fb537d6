// SPDX-License-Identifier: MIT
// How many vertices of the mesh lie in a cell.
#pragma once

#include <vector>

#include "mesh/marks.h"
#include "split/cell_triangles.h"

namespace kdm {

/// Counts each vertex of a cell's triangles once. One object serves cell after cell, so that no
/// array over all vertices has to be cleared for a cell.
class VertexCounter {
 public:
  explicit VertexCounter(const Surface& surface);

  /// Returns the number of the members' corners that lie in the cell and not on the surface's rim.
  Index count_inner(const CellTriangles& triangles);

 private:
  Marks on_rim_;                   // per point; empty where sides always have opposites
  std::vector<Index> last_count_;  // per point: the number of the last count that met it
  Index counts_ = 0;
};

}  // namespace kdm
