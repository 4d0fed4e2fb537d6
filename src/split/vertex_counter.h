// SPDX-License-Identifier: MIT
// How many vertices of the mesh lie in a cell.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "mesh/marks.h"
#include "split/cell_triangles.h"

namespace kdm {

/// A piece's number within the cell at hand. Pieces are numbered by their lowest members.
using PieceId = Index;

/// Counts each vertex of a cell's triangles once for each piece that has it. One object serves cell
/// after cell, so that no array over all vertices has to be cleared for a cell.
class VertexCounter {
 public:
  explicit VertexCounter(const Surface& surface);

  /// Returns the number of the members' corners that lie in the cell and not on the surface's rim.
  /// `piece_of` holds the piece of each member. Corners of one piece that lie at one point count
  /// once, those of two pieces that touch there twice.
  Index count_inner(const CellTriangles& triangles, std::span<const MemberId> members,
                    std::span<const PieceId> piece_of);

 private:
  struct Met {
    Index count = 0;    // the number of the last count that met the point
    PieceId piece = 0;  // by which piece it was met first
  };

  Marks on_rim_;           // per point; empty where sides always have opposites
  std::vector<Met> last_;  // per point
  std::vector<std::pair<PointId, PieceId>> others_;  // more pieces at points, of the cell at hand
  Index counts_ = 0;
};

}  // namespace kdm
