// SPDX-License-Identifier: MIT
// Decides whether a result is reduced.
#pragma once

#include "kdmanifold/make_manifold.h"

namespace kdm {

/// The part of the tolerance that the grid of a result to be reduced may take. From half to all of
/// it it makes next to no difference to the number of triangles; the less, the longer it takes, and
/// from nine tenths on results are further off.
inline constexpr double kGridShare = 0.8;

/// Says whether the result of a grid that was built before is to be reduced: if this is asked for,
/// or if the grid was built for it. Throws `kInvalidOption` as `reduces` does.
bool reduces(const GridStats& grid, const ExtractOptions& extract,
             const ReductionOptions& reduction);

/// Throws `kInvalidOption` if the options of extraction exclude reduction, which the option `asked`
/// asks for.
void check_reducible(const ExtractOptions& extract, const char* asked);

}  // namespace kdm
