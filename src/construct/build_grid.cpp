// SPDX-License-Identifier: MIT
// Turns a mesh into a grid.
#include "construct/build_grid.h"

#include <array>
#include <new>
#include <utility>

#include "construct/exact_parts.h"
#include "construct/grid_of_surface.h"
#include "inside/make_inside_model.h"
#include "kdmanifold/error.h"
#include "kdmanifold/options.h"
#include "kdmanifold/thicken.h"
#include "mesh/progress.h"
#include "prepare/surface.h"
#include "text/compose.h"

namespace kdm {
namespace {

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

}  // namespace

Grid build_grid(const Mesh& mesh, const BuildOptions& options, const Progress& progress) {
  return build_grid_within(mesh, options, 1, progress);
}

Grid build_grid_within(const Mesh& mesh, const BuildOptions& options, double share,
                       const Progress& progress) try {
  check_options(options);
  report_progress(progress, 0.0, "prepare");
  const bool thickens_all = options.thicken > 0 && options.thicken_what == ThickenWhat::kAll;
  Surface surface = thickens_all ? prepare_surface(thicken(mesh, options.thicken), options)
                                 : prepare_surface(mesh, options);
  check_thickness(options.thicken, surface.lattice.step);
  const double tolerance = share * lattice_tolerance(surface, options);
  SolidStates states(SolidFunction(0, std::array<Index, 1>{0}), {options.inside});
  ExactParts exact = take_exact_parts(surface, states, options);
  const std::unique_ptr<InsideModel> model = make_inside_model(surface, options, tolerance);
  return Grid(grid_of_surface(surface, *model, options, tolerance, std::move(exact), progress));
} catch (const std::bad_alloc&) {
  throw Error(ErrorCode::kOutOfMemory, "there is not enough memory to build the grid");
}

}  // namespace kdm
