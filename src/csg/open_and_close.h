// SPDX-License-Identifier: MIT
// Leaves out what is thinner than some thickness, and fills gaps that are narrower than some width.
#pragma once

#include "kdmanifold/build.h"
#include "prepare/surface.h"

namespace kdm {

/// Returns whether the options ask for either.
inline bool opens_or_closes(const BuildOptions& options) {
  return options.minimum_thickness > 0 || options.minimum_gap > 0;
}

/// Returns the grid without what is thinner than `minimum_thickness`, then with the gaps narrower
/// than `minimum_gap` filled. `plain` is the grid of the surface as it is, and comes back if there
/// is nothing of the kind. How thick the solid is, is measured on the surface that `plain` stands
/// for. `tolerance` is in lattice units. Throws `kEmptyResult` if all is thinner, and
/// `kInvalidOption` for a size that is too small for the surface's area.
Grid open_and_close(Grid plain, Surface surface, const BuildOptions& options, double tolerance,
                    const Progress& progress);

}  // namespace kdm
