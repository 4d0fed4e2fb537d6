// SPDX-License-Identifier: MIT
// Links half-edges of a grid whose cells round all hits are of the greatest depth.
#pragma once

#include <span>
#include <vector>

#include "grid/finest_tree.h"
#include "kdmanifold/build.h"
#include "prepare/surface.h"

namespace kdm {

/// Two splitting edges with the same hits on one grid line. Of the two grid planes that meet in the
/// line, the one across `split_axis` splits deeper cells: two of them, one below and one above the
/// plane across `side_axis`.
struct TwinEdges {
  int axis;  ///< along which they run
  int split_axis;
  int side_axis;
  LatticePoint place;  ///< of a cell of the greatest depth above both planes (see FinestCells)
  EdgeId below;        ///< the edge of the split below the plane across `side_axis`
  EdgeId above;
};

/// A grid that was made from its finest cells upwards.
struct FinestGrid {
  FinestTree tree;
  std::vector<TwinEdges> edges;  ///< all that have hits
};

/// Links all half-edges of a solid, with the same result as `link_half_edges`. Here each hit says
/// which leaves are round it and which minimal faces its half-edges cross, so no cells are walked
/// over: where two half-edges cross a face they are a pair; for faces with more, a matcher is
/// asked.
void link_finest(const Surface& surface, std::span<const TriangleId> triangle_of_hit,
                 Pairing pairing, const FinestGrid& finest, GridData& grid);

}  // namespace kdm
