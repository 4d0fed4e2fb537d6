// SPDX-License-Identifier: MIT
// Non-crossing pairings of points on a circle: the cheapest, and that of brackets.
#pragma once

#include <functional>
#include <vector>

#include "kdmanifold/types.h"

namespace kdm {

/// Pairs 0 .. count-1, given in cyclic order, without crossings, so that every pair has an even
/// number of points between them and the sum of `cost(i, j)`, i < j, is least. `count` is even.
/// Pairs of infinite cost are made only if nothing else is left. Returns each point's partner.
/// Cubic time.
std::vector<Index> match_without_crossings(Index count,
                                           const std::function<double(Index, Index)>& cost);

/// Pairs every point that opens with the one that closes, as brackets round the circle; as many
/// open as close. Where they alternate, neighbours are paired. Returns each point's partner. Linear
/// time.
std::vector<Index> match_brackets(const std::vector<bool>& opens);
/// Pairs as many of the points as it can without crossings, only those that `may_pair(i, j)`, i <
/// j; of such pairings the one of least cost. Returns each point's partner or kNone. Cubic time;
/// more than 256 points are paired with the next one they may be paired with, inside out.
std::vector<Index> match_some(Index count, const std::function<bool(Index, Index)>& may_pair,
                              const std::function<double(Index, Index)>& cost);

}  // namespace kdm
