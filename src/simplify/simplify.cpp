// SPDX-License-Identifier: MIT
// Simplifies a copy of the grid, which takes its place in the end.
#include "kdmanifold/simplify.h"

#include <cmath>
#include <limits>
#include <memory>
#include <new>
#include <utility>

#include "kdmanifold/error.h"
#include "kdmanifold/extract.h"
#include "kdmanifold/options.h"
#include "mesh/progress.h"
#include "simplify/split_remover.h"
#include "simplify/thin_regions.h"
#include "text/compose.h"

namespace kdm {
namespace {

// What rounding may leave of an error that was used up.
constexpr double kNothing = 1e-9;
// The part of the work that is done before the first split is removed.
constexpr double kBefore = 0.3;
// The part of it that goes to what is thin.
constexpr double kThin = 0.2;
constexpr Index kBetweenReports = 32;

GridData simplified(const GridData& data, const SimplifyOptions& options, double distance,
                    const Progress& progress, SimplifyReport& report) {
  const double step = data.lattice.step;
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

// The grid without what is thin, or nothing if all stays.
std::unique_ptr<GridData> without_thin(const GridData& data, const SimplifyOptions& options,
                                       const Progress& progress, SimplifyReport& report) {
  for (const auto& [name, size] : {std::pair("removed_material", options.removed_material),
                                   std::pair("added_material", options.added_material)}) {
    if (size == 0 || !data.sheet) continue;
    throw Error(ErrorCode::kInvalidOption,
                compose("`{}`: not of a sheet, which bounds no material", name));
  }
  if (options.removed_material == 0 && options.added_material == 0) return nullptr;
  auto out = std::make_unique<GridData>(data);
  const auto take = [&](double thickness, bool material, const Progress& part) -> Index {
    if (thickness == 0) return 0;
    const GoneRegions gone = take_thin_regions(*out, thickness / data.lattice.step, material, part);
    if (gone.regions > 0 && gone.left == 0) {
      throw Error(ErrorCode::kEmptyResult, "all of the solid is thinner than `removed_material`");
    }
    report.removed_surfaces += gone.surfaces;
    report.removed_handles += gone.handles;
    return gone.regions;
  };
  report.removed_parts =
      take(options.removed_material, true, part_of_progress(progress, 0, kThin / 2));
  report.filled_cavities =
      take(options.added_material, false, part_of_progress(progress, kThin / 2, kThin));
  if (report.removed_surfaces == 0) return nullptr;
  return out;
}

}  // namespace

SimplifyReport simplify(Grid& grid, const SimplifyOptions& options, const Progress& progress) try {
  check_options(options);
  const GridData& data = grid.data();
  report_progress(progress, 0, "simplify");
  SimplifyReport report;
  report.cells_before = static_cast<Index>(data.cells.size());
  report.hits_before = static_cast<Index>(data.hits.size());
  const double distance = options.surface_error - data.simplified;
  std::unique_ptr<GridData> out = without_thin(data, options, progress, report);
  const GridData& kept = out ? *out : data;
  if (distance > kNothing * options.surface_error && !kept.hits.empty()) {
    out = std::make_unique<GridData>(simplified(kept, options, distance, progress, report));
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
