// SPDX-License-Identifier: MIT
// Decides whether a result is reduced.
#pragma once

#include "kdmanifold/make_manifold.h"

namespace kdm {

/// The part of the tolerance that the grid of a result to be reduced may take; the other part is
/// left to collapsed edges.
inline constexpr double kGridShare = 0.5;

/// Says whether the result of a grid that was built before is to be reduced: if this is asked for,
/// or if the grid was built for it. Throws `kInvalidOption` as `reduces` does.
bool reduces(const GridStats& grid, const ExtractOptions& extract,
             const ReductionOptions& reduction);

/// Throws `kInvalidOption` if the options of extraction exclude reduction, which the option `asked`
/// asks for.
void check_reducible(const ExtractOptions& extract, const char* asked);

}  // namespace kdm
