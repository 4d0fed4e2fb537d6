// SPDX-License-Identifier: MIT
#include "csg/grid_of_faces.h"

#include <array>
#include <memory>
#include <utility>

#include "construct/exact_parts.h"
#include "construct/grid_of_surface.h"
#include "csg/open_and_close.h"
#include "inside/make_inside_model.h"
#include "kdmanifold/error.h"
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

Grid grid_of_faces(InputFaces faces, const BuildOptions& options, double share, double threshold,
                   const Progress& progress) {
  Surface surface = prepare_surface(std::move(faces), options);
  check_thickness(options.thicken, surface.lattice.step);
  const double tolerance = share * lattice_tolerance(surface, options);
  Surface whole = opens_or_closes(options) ? surface : Surface();
  SolidStates states(SolidFunction(0, std::array<Index, 1>{0}), {options.inside});
  ExactParts exact = take_exact_parts(surface, states, options);
  const std::unique_ptr<InsideModel> model = make_inside_model(surface, options, tolerance);
  std::unique_ptr<GridData> grid =
      grid_of_surface(surface, *model, options, tolerance, std::move(exact),
                      opens_or_closes(options) ? part_of_progress(progress, 0, 0.5) : progress);
  if (threshold > 0) grid->stats.winding_threshold = threshold;
  if (!opens_or_closes(options)) return Grid(std::move(grid));
  return open_and_close(Grid(std::move(grid)), std::move(whole), options, tolerance,
                        part_of_progress(progress, 0.5, 1));
}

}  // namespace kdm
