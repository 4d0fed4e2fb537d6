// SPDX-License-Identifier: MIT
// Follows the grid lines through the cells of the greatest depth, and keeps the crossings that
// bound the solid.
#pragma once

#include <vector>

#include "construct/finest_marking.h"
#include "grid/finest_tree.h"
#include "inside/inside_model.h"
#include "kdmanifold/progress.h"
#include "link/link_finest.h"

namespace kdm {

/// The splitting edges with hits, and the crossings that become these.
struct LinePlan {
  std::vector<TwinEdges> edges;
  std::vector<Index> begin{0};  ///< per twin edges their first crossing; last, how many there are
  std::vector<ClassifiedCrossing> crossings;  ///< ascending along each edge
};

/// Follows each line from the outside through its splitting edges and asks the model about each
/// edge, as a recursion from the root would. `crossings` hold all that there are on the lines, in
/// any order. The model must only count.
LinePlan plan_lines(const std::vector<LineCrossing>& crossings, const FinestTree& tree,
                    InsideModel& model, const Progress& progress);

}  // namespace kdm
