// SPDX-License-Identifier: MIT
// Puts the steps together, and says what holds for the whole.
#include "kdmanifold/make_manifold.h"

#include <string>
#include <string_view>
#include <utility>

#include "csg/build_grid.h"
#include "csg/solids_builder.h"
#include "extract/warnings.h"
#include "kdmanifold/error.h"
#include "kdmanifold/options.h"
#include "make/make_solids.h"
#include "make/reduction_rule.h"
#include "make/step_shares.h"
#include "mesh/measure.h"
#include "mesh/progress.h"
#include "reduce/face_groups.h"

namespace kdm {
namespace {

// Tolerances that were asked for and used agree but for rounding.
constexpr double kWider = 1.001;

Progress begin(const StepProgress& progress, MakeStep step) {
  return progress ? progress(step) : Progress();
}

// Makes the grid's own surface.
MadeMesh extract_step(const Grid& grid, const ExtractOptions& options,
                      const StepProgress& progress) {
  MadeMesh made;
  static_cast<ExtractedMesh&>(made) = extract(grid, options, begin(progress, MakeStep::kExtract));
  made.stats = grid.stats();
  return made;
}

// The same, fit to be reduced.
MadeMesh extract_embedded(const Grid& grid, ExtractOptions options, const StepProgress& progress) {
  options.strict = Strict::kEmbedded;
  return extract_step(grid, options, progress);
}

// Puts the reduced mesh in the place of the extracted one.
void reduce_step(const Mesh& reference, const ReduceOptions& options, const StepProgress& progress,
                 MadeMesh& made) {
  ReducedMesh reduced = reduce(made, reference, options, begin(progress, MakeStep::kReduce));
  static_cast<Mesh&>(made) = std::move(static_cast<Mesh&>(reduced));
  made.levels = std::move(reduced.levels);
  made.reduced = reduced.report;
  // Those that are left of the few that embedding could not take apart.
  if (made.report.crossings.value_or(0) > 0) {
    made.report.crossings = find_self_intersections(made).pairs;
  }
}

// Simplifies the grid. Errors name the options as they are called here.
SimplifyReport simplify_step(Grid& grid, const ReductionOptions& options,
                             const StepProgress& progress) try {
  return simplify(grid,
                  {.surface_error = options.simplify,
                   .removed_material = options.remove_material,
                   .added_material = options.add_material},
                  begin(progress, MakeStep::kSimplify));
} catch (const Error& error) {
  std::string text = error.what();
  for (const auto& [theirs, ours] : {std::pair("`removed_material`", "`remove_material`"),
                                     std::pair("`added_material`", "`add_material`")}) {
    const std::size_t at = text.find(theirs);
    if (at != std::string::npos) text.replace(at, std::string_view(theirs).size(), ours);
  }
  throw Error(error.code(), text);
}

// Says what there is to warn of once the result is reduced.
void warn_again(const InputReport& input, MadeMesh& made) {
  made.warnings = collect_warnings(input, made.stats, made.report, area_of(made));
}

// Lets the account speak of the tolerance that the whole keeps.
void state_tolerance(const InputReport& input, double tolerance, MadeMesh& made) {
  made.stats.tolerance = tolerance;
  warn_again(input, made);
}

// How far the result may be from the input: what was asked for, unless the grid had to take more
// than its share.
double whole_tolerance(const GridStats& grid) {
  const double tolerance = grid.tolerance / kGridShare;
  return tolerance < kWider * grid.asked_tolerance ? grid.asked_tolerance : tolerance;
}

// How far a result may be from the grid's own surface: what the grid left of the tolerance, or as
// much as the grid itself took if that is little.
double left_tolerance(const GridStats& grid) {
  constexpr double kLittle = 0.1;
  const double left = grid.asked_tolerance - grid.tolerance;
  return left > kLittle * grid.tolerance ? left : grid.tolerance;
}

// Makes the result of the grid that was built, if it is to be simplified.
MadeManifold make_simplified(Grid grid, const MakeOptions& options, const StepProgress& progress) {
  MadeManifold out;
  out.grid = std::move(grid);
  static_cast<MadeMesh&>(out) =
      make_from_grid(out.grid, options.extract, options.reduction, progress);
  return out;
}

}  // namespace

MadeManifold make_manifold_in_steps(const Mesh& mesh, const MakeOptions& options,
                                    const StepProgress& progress) {
  const bool is_reduced = reduces(options);
  check_groups(mesh, options.reduction.keep_groups);
  MadeManifold out;
  out.grid = build_grid_within(mesh, options.build, is_reduced ? kGridShare : 1,
                               begin(progress, MakeStep::kBuild));
  if (options.reduction.simplify > 0) {
    return make_simplified(std::move(out.grid), options, progress);
  }
  MadeMesh& made = out;
  if (!is_reduced) {
    made = extract_step(out.grid, options.extract, progress);
    return out;
  }
  made = extract_embedded(out.grid, options.extract, progress);
  const GridStats& stats = out.grid.stats();
  const bool off_input = options.build.thicken > 0;
  const Mesh own = off_input ? static_cast<const Mesh&>(made) : Mesh();
  reduce_step(
      off_input ? own : mesh,
      {.error = off_input ? whole_tolerance(stats) - stats.tolerance : whole_tolerance(stats),
       .target_triangles = options.reduction.target_triangles,
       .keep_groups = options.reduction.keep_groups},
      progress, made);
  state_tolerance(out.grid.input(), whole_tolerance(stats), made);
  return out;
}

void check_for_solids(const MakeOptions& options) {
  if (options.reduction.keep_groups.empty()) return;
  throw Error(ErrorCode::kInvalidOption, "`keep_groups`: not of several solids");
}

MadeManifold make_solids(SolidsBuilder& builder, const MakeOptions& options,
                         const StepProgress& progress) {
  const bool is_reduced = reduces(options);
  SolidsGrid built =
      builder.build(is_reduced ? kGridShare : 1,
                    is_reduced ? SolidsBuilder::Faces::kToo : SolidsBuilder::Faces::kLeftOut,
                    begin(progress, MakeStep::kBuild));
  if (options.reduction.simplify > 0) {
    return make_simplified(std::move(built.grid), options, progress);
  }
  MadeManifold out;
  out.grid = std::move(built.grid);
  MadeMesh& made = out;
  if (!is_reduced) {
    made = extract_step(out.grid, options.extract, progress);
    return out;
  }
  made = extract_embedded(out.grid, options.extract, progress);
  const double tolerance = whole_tolerance(out.grid.stats());
  reduce_step(built.faces,
              {.error = tolerance, .target_triangles = options.reduction.target_triangles},
              progress, made);
  state_tolerance(out.grid.input(), tolerance, made);
  return out;
}

MadeManifold make_solids_in_steps(const Expression& expression,
                                  const std::vector<Operand>& operands, const MakeOptions& options,
                                  const StepProgress& progress) {
  check_for_solids(options);
  SolidsBuilder builder(operands, expression, options.build, SolidsBuilder::Builds::kOnce);
  return make_solids(builder, options, progress);
}

MadeManifold make_manifold(const Mesh& mesh, const MakeOptions& options, const Progress& progress) {
  MadeManifold made = make_manifold_in_steps(mesh, options, shares_of(progress));
  report_progress(progress, 1.0, "done");
  return made;
}

MadeMesh make_from_grid(Grid& grid, const ExtractOptions& extract,
                        const ReductionOptions& reduction, const StepProgress& progress) {
  const bool is_reduced = reduces(grid.stats(), extract, reduction);
  std::optional<SimplifyReport> simplified;
  if (reduction.simplify > 0) {
    simplified = simplify_step(grid, reduction, progress);
  }
  MadeMesh made = is_reduced ? extract_reduced(grid, extract,
                                               {.error = left_tolerance(grid.stats()),
                                                .target_triangles = reduction.target_triangles,
                                                .keep_groups = reduction.keep_groups},
                                               progress)
                             : extract_step(grid, extract, progress);
  made.simplified = simplified;
  return made;
}

MadeMesh extract_reduced(const Grid& grid, const ExtractOptions& extract,
                         const ReduceOptions& options, const StepProgress& progress) {
  check_reducible(extract, "reduce");
  check_options(options);
  MadeMesh made = extract_embedded(grid, extract, progress);
  const Mesh own = made;
  reduce_step(own, options, progress, made);
  // Nothing had to be widened: the distance was asked for.
  warn_again(grid.input(), made);
  made.stats.tolerance += options.error;
  return made;
}

}  // namespace kdm
