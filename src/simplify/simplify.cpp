// SPDX-License-Identifier: MIT
// Simplifies a copy of the grid, which takes its place in the end.
#include "kdmanifold/simplify.h"

#include <cmath>
#include <limits>
#include <memory>
#include <new>

#include "kdmanifold/error.h"
#include "kdmanifold/extract.h"
#include "kdmanifold/options.h"
#include "mesh/progress.h"
#include "simplify/split_remover.h"

namespace kdm {
namespace {

// What rounding may leave of an error that was used up.
constexpr double kNothing = 1e-9;
// The part of the work that is done before the first split is removed.
constexpr double kBefore = 0.3;
constexpr Index kBetweenReports = 32;

GridData simplified(const GridData& data, const SimplifyOptions& options, double distance,
                    const Progress& progress, SimplifyReport& report) {
  const double step = data.lattice.step;
  report_progress(progress, 0, "simplify");
  auto own = std::make_unique<GridData>(data);
  own->exact = {};  // no split has a part in it
  const Mesh reference = extract(Grid(std::move(own)), {.strict = Strict::kManifold});
  WorkGrid work(data);
  NearSurface near(work, reference, distance / step);
  report_progress(progress, kBefore, "simplify");
  const double most = options.plane_error / step;
  SplitRemover remover(
      work, near, options.plane_error > 0 ? most * most : std::numeric_limits<double>::infinity());
  while (remover.remove_next()) {
    if (remover.removed() % kBetweenReports != 0) continue;
    report_progress(progress, kBefore + (1 - kBefore) * remover.removed() / data.splits(),
                    "simplify");
  }
  report.removed_splits = remover.removed();
  report.plane_error = std::sqrt(remover.largest_cost()) * step;
  return work.result(distance);
}

}  // namespace

SimplifyReport simplify(Grid& grid, const SimplifyOptions& options, const Progress& progress) try {
  check_options(options);
  const GridData& data = grid.data();
  SimplifyReport report;
  report.cells_before = static_cast<Index>(data.cells.size());
  report.hits_before = static_cast<Index>(data.hits.size());
  const double distance = options.surface_error - data.simplified;
  std::unique_ptr<GridData> out;
  if (distance > kNothing * options.surface_error && !data.hits.empty()) {
    out = std::make_unique<GridData>(simplified(data, options, distance, progress, report));
  }
  const GridData& now = out ? *out : data;
  report.cells = static_cast<Index>(now.cells.size());
  report.hits = static_cast<Index>(now.hits.size());
  report.allowed_error = now.simplified;
  report_progress(progress, 1, "simplify");
  if (out) grid = Grid(std::move(out));
  return report;
} catch (const std::bad_alloc&) {
  throw Error(ErrorCode::kOutOfMemory, "there is not enough memory to simplify the grid");
}

}  // namespace kdm
