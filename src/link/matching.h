// SPDX-License-Identifier: MIT
// Pairs points on a circle without crossings: at the least cost, or as opening and closing brackets
// are paired.
#pragma once

#include <functional>
#include <vector>

#include "kdmanifold/types.h"

namespace kdm {

/// Pairs the points 0 to count - 1, numbered in cyclic order, so that no two pairs cross and the
/// sum of `cost(i, j)`, i < j, over the pairs is least. `count` is even. Pairs of infinite cost are
/// made only if nothing else is left. Returns each point's partner. Cubic time.
std::vector<Index> match_without_crossings(Index count,
                                           const std::function<double(Index, Index)>& cost);

/// Reads the points as brackets round the circle, of which as many open as close, and pairs each
/// one that opens with the one that closes it. Where the two kinds alternate, neighbours are
/// paired. Returns each point's partner. Linear time.
std::vector<Index> match_brackets(const std::vector<bool>& opens);

/// Pairs as many of the points 0 to count - 1 as possible, without crossings, where points i < j
/// may be a pair only if `may_pair(i, j)`. Of all pairings with as many pairs, takes the one with
/// the least sum of `cost(i, j)`. Returns each point's partner, or kNone. Cubic time. More than 256
/// points are not paired at the least cost: each point is paired with the last point before it that
/// is still free, if the two may be a pair. This takes linear time.
std::vector<Index> match_some(Index count, const std::function<bool(Index, Index)>& may_pair,
                              const std::function<double(Index, Index)>& cost);

}  // namespace kdm
