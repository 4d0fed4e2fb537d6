// SPDX-License-Identifier: MIT
// The cheapest non-crossing pairing of points on a circle.
#pragma once

#include <functional>
#include <vector>

#include "kdmanifold/types.h"

namespace kdm {

/// Pairs 0 .. count-1, given in cyclic order, without crossings, so that every pair has an even
/// number of points between them and the sum of `cost(i, j)`, i < j, is least. `count` is even.
/// Returns each point's partner. Cubic time.
std::vector<Index> match_without_crossings(Index count,
                                           const std::function<double(Index, Index)>& cost);

}  // namespace kdm
