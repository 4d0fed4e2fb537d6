// SPDX-License-Identifier: MIT
#include "construct/grid_of_surface.h"

#include <utility>

#include "construct/construct.h"
#include "grid/count_stats.h"
#include "grid/pillows.h"
#include "kdmanifold/error.h"
#include "kdmanifold/options.h"
#include "link/corners.h"
#include "link/link.h"
#include "link/link_finest.h"
#include "mesh/progress.h"

namespace kdm {
namespace {

// What later steps take for the tolerance where cells were made without one, as a fraction of the
// bounding box's diagonal.
constexpr double kUsualTolerance = BuildOptions().relative_tolerance;

// Returns the depth that no cell goes beyond.
int depth_limit(const BuildOptions& options) {
  constexpr int kUniformDepth = 18;
  if (options.cells != 0) return 3 * halvings_for(options.cells);
  if (options.depth != 0) return options.depth;
  return options.strategy == SplitStrategy::kUniform ? kUniformDepth : kMaxDepth;
}

}  // namespace

double lattice_tolerance(const Surface& surface, const BuildOptions& options) {
  return options.cells > 0 ? 0 : tolerance_of(options, surface.extent) / surface.lattice.step;
}

std::unique_ptr<GridData> grid_of_surface(const Surface& surface, InsideModel& model,
                                          const BuildOptions& options, double tolerance,
                                          ExactParts exact, const Progress& progress,
                                          const CellMemory& memory) {
  auto grid = std::make_unique<GridData>();
  grid->sheet = surface.sheet;
  grid->inside = options.inside;
  grid->thickness = options.thicken;
  grid->lattice = surface.lattice;
  grid->input = surface.report;
  report_progress(progress, 0.1, "build");
  const ConstructedCells made =
      construct_cells(surface, model, options, tolerance, depth_limit(options), memory,
                      part_of_progress(progress, 0.1, 0.8), *grid);
  grid->exact = std::move(exact.mesh);
  grid->stats.exact_parts = exact.parts;
  grid->stats.thin_parts = exact.inexact;
  grid->stats.asked_tolerance = tolerance_of(options, surface.extent);
  grid->tolerance =
      made.tolerance > 0 ? made.tolerance : kUsualTolerance * surface.extent / surface.lattice.step;
  report_progress(progress, 0.8, "link");
  if (surface.repair && grid->hits.empty()) {
    throw Error(ErrorCode::kNotClosed,
                "the surface encloses nothing: it is open, and no point lies behind it on most "
                "sides; thicken it, or take it as a sheet");
  }
  if (made.finest && !surface.sheet) {
    link_finest(surface, made.triangle_of_hit, options.pairing, *made.finest, *grid);
  } else {
    link_half_edges(surface, made.triangle_of_hit, options.pairing, *grid);
  }
  keep_corners(surface, made.triangle_of_hit, *grid);
  count_stats(*grid);
  GridStats& stats = grid->stats;
  for (Vec3& p : stats.unresolved_positions) p = grid->lattice.to_model(p);
  stats.topology_resolved = stats.topology_resolved && stats.guessed_faces == 0 &&
                            !surface.repair && surface.report.rebuilt_parts == 0 &&
                            !has_pillows(*grid);
  report_progress(progress, 1.0, "link");
  return grid;
}

}  // namespace kdm
