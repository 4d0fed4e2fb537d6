// SPDX-License-Identifier: MIT
// Turns a mesh into a grid: prepares the surface, constructs cells and hits, and links half-edges.
#include "construct/build_grid.h"

#include <new>

#include "construct/construct.h"
#include "grid/count_stats.h"
#include "kdmanifold/error.h"
#include "kdmanifold/options.h"
#include "kdmanifold/thicken.h"
#include "link/corners.h"
#include "link/link.h"
#include "mesh/progress.h"
#include "prepare/surface.h"
#include "text/compose.h"

namespace kdm {
namespace {

// What later steps take for the tolerance where cells were made without one, as a fraction of the
// bounding box's diagonal.
constexpr double kUsualTolerance = BuildOptions().relative_tolerance;

// Checks that the sides of a thickened surface do not round to the same places: then the shell
// between them would have no inside. `step` is a lattice unit, in model units.
void check_thickness(double thickness, double step) {
  constexpr double kLeast = 4;  // lattice units
  if (thickness == 0 || thickness >= kLeast * step) return;
  throw Error(ErrorCode::kInvalidOption,
              compose("thicken is {}; for a model of this size it must be {} at least, a "
                      "millionth of its extent",
                      thickness, kLeast * step));
}

// Returns the depth that no cell goes beyond.
int depth_limit(const BuildOptions& options) {
  constexpr int kUniformDepth = 18;
  if (options.depth != 0) return options.depth;
  return options.strategy == SplitStrategy::kUniform ? kUniformDepth : kMaxDepth;
}

}  // namespace

Grid build_grid(const Mesh& mesh, const BuildOptions& options, const Progress& progress) {
  return build_grid_within(mesh, options, 1, progress);
}

Grid build_grid_within(const Mesh& mesh, const BuildOptions& options, double share,
                       const Progress& progress) try {
  check_options(options);
  report_progress(progress, 0.0, "prepare");
  const Surface surface = options.thicken > 0
                              ? prepare_surface(thicken(mesh, options.thicken), options)
                              : prepare_surface(mesh, options);
  check_thickness(options.thicken, surface.lattice.step);
  auto grid = std::make_unique<GridData>();
  grid->sheet = surface.sheet;
  grid->inside = options.inside;
  grid->thickness = options.thicken;
  grid->lattice = surface.lattice;
  grid->input = surface.report;
  report_progress(progress, 0.1, "build");
  const ConstructedCells made = construct_cells(
      surface, options, share * tolerance_of(options, surface.extent) / surface.lattice.step,
      depth_limit(options), part_of_progress(progress, 0.1, 0.8), *grid);
  grid->stats.asked_tolerance = tolerance_of(options, surface.extent);
  grid->tolerance =
      made.tolerance > 0 ? made.tolerance : kUsualTolerance * surface.extent / surface.lattice.step;
  report_progress(progress, 0.8, "link");
  if (surface.repair && grid->hits.empty()) {
    throw Error(ErrorCode::kNotClosed,
                "the surface encloses nothing: it is open, and no point lies behind it on most "
                "sides; thicken it, or take it as a sheet");
  }
  link_half_edges(surface, made.triangle_of_hit, options.pairing, *grid);
  keep_corners(surface, made.triangle_of_hit, *grid);
  count_stats(*grid);
  GridStats& stats = grid->stats;
  for (Vec3& p : stats.unresolved_positions) p = grid->lattice.to_model(p);
  stats.topology_resolved = stats.topology_resolved && stats.guessed_faces == 0 && !surface.repair;
  report_progress(progress, 1.0, "link");
  return Grid(std::move(grid));
} catch (const std::bad_alloc&) {
  throw Error(ErrorCode::kOutOfMemory, "there is not enough memory to build the grid");
}

}  // namespace kdm
