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
  /// Bodies go, each with the cavities in it, into which no ball fits that is wider than this, in
  /// model units: what the paper's in-metric bounds. 0: none.
  double removed_material = 0;
  /// Cavities are filled into which no ball fits that is wider than this, in model units, once the
  /// bodies have gone: what the paper's out-metric bounds. 0: none.
  double added_material = 0;
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
  Index removed_parts = 0;     ///< bodies that went because of `removed_material`
  Index filled_cavities = 0;   ///< cavities that were filled because of `added_material`
  Index removed_surfaces = 0;  ///< closed surfaces that bounded these bodies and cavities
  Index removed_handles = 0;   ///< handles that these surfaces had
};

/// Removes splits between two leaves, the cheapest first, as long as no part of the surface and no
/// handle comes or goes and the surface stays within the distance: points of the mesh that
/// `extract` made of the grid before the call, and points of the new one, twice the distance apart,
/// are tested against each other. Between these points it may be a little further off. Not tested
/// are vertices that `extract` adds afterwards, to embed a mesh, to keep it manifold, or where
/// edges pass between cells (`link_error`). The last may be well off in a grid that was stopped by
/// its depth: 2 % of the model's size were measured on one without a tolerance. The new vertices
/// are where the planes of all hits that they stand for are met best, and the grid keeps them:
/// `extract` places them there, also when the grid was saved.
///
/// Before the first split, what is thin goes if `removed_material` or `added_material` is above 0,
/// and is counted exactly: the grid's surface then has `removed_surfaces` closed surfaces and
/// `removed_handles` handles less. No other change of topology is ever taken. A body goes as a
/// whole or stays: bars are not cut, tunnels and gaps that lead outside stay open, and bodies stay
/// apart, but for those in a cavity that is filled, which become one with what is round it.
/// (`minimum_thickness` and `minimum_gap` of `BuildOptions` do more.) Thickness is that of the
/// surface that the grid has when the call begins, with one triangle for each hit; what comes
/// within a tenth of the limit may stay. The distance holds for the surface that is left. Pillows
/// are no part of a result and are not counted; crumbs, which `extract` leaves out too, are. All
/// stays where surfaces meet or cross, so that it is not sure what lies in what, and if finding
/// that out would take more than about a second.
///
/// Calls add up: another one with the same `surface_error` removes no split, one with a larger goes
/// on. What is thin goes in any call. If the call throws, the grid is what it was.
///
/// Throws `kInvalidOption`, also for one of the last two options and a sheet, which bounds nothing;
/// `kEmptyResult` if all bodies would go; `kAborted`, `kOutOfMemory`, and what `extract` throws for
/// a grid whose surface is empty.
SimplifyReport simplify(Grid& grid, const SimplifyOptions& options, const Progress& progress = {});

}  // namespace kdm
