// SPDX-License-Identifier: MIT
// Builds a grid that leaves a part of the tolerance to what comes after it.
#pragma once

#include "kdmanifold/build.h"

namespace kdm {

/// Does what `build_grid` does, with cells that meet the surface within `share` (above 0, at most
/// 1) of the tolerance. All else, such as sewing, goes by the whole tolerance, which
/// `GridStats::asked_tolerance` keeps.
Grid build_grid_within(const Mesh& mesh, const BuildOptions& options, double share,
                       const Progress& progress);

}  // namespace kdm
