// SPDX-License-Identifier: MIT
// Makes a grid smaller: splits are removed as long as the surface that the grid stands for stays
// near to what it was (paper section 4).
#pragma once

#include "kdmanifold/grid.h"
#include "kdmanifold/progress.h"

namespace kdm {

/// What `simplify` can be told.
struct SimplifyOptions {
  /// How far the surface may be, either way, from what it was when the grid was built, in model
  /// units; above 0. What calls before have used up counts.
  double surface_error = 0;
  /// The paper's on-metric as a further limit: the root mean square distance of the hits that were
  /// merged into one from the plane that fits them best, in model units. 0: no limit.
  double plane_error = 0;
};

/// What was done.
struct SimplifyReport {
  Index removed_splits = 0;  ///< splits that were removed
  Index cells_before = 0;    ///< nodes of the kd-tree before the call
  Index cells = 0;           ///< nodes that are left
  Index hits_before = 0;     ///< hits before the call
  Index hits = 0;            ///< hits that are left
  /// The largest root mean square distance of merged hits from the plane that fits them best, in
  /// model units.
  double plane_error = 0;
  /// How far the surface may now be from what it was when the grid was built: what all calls have
  /// been allowed, in model units.
  double allowed_error = 0;
};

/// Removes splits between two leaves, the cheapest first, as long as no part of the surface and no
/// handle comes or goes and the surface stays within the distance: points of the mesh that
/// `extract` made of the grid before the call, and points of the new one, twice the distance apart,
/// are tested against each other. Between these points it may be a little further off. Not tested
/// are vertices that `extract` adds afterwards, to embed a mesh or to keep it manifold. The new
/// vertices are where the planes of all hits that they stand for are met best, and the grid keeps
/// them: `extract` places them there, also when the grid was saved.
///
/// Calls add up: another one with the same `surface_error` does nothing, one with a larger goes on.
/// If the call throws, the grid is what it was.
///
/// Throws `kInvalidOption`, `kAborted`, `kOutOfMemory`, and what `extract` throws for a grid whose
/// surface is empty.
SimplifyReport simplify(Grid& grid, const SimplifyOptions& options, const Progress& progress = {});

}  // namespace kdm
