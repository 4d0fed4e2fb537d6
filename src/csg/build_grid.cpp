// SPDX-License-Identifier: MIT
// Turns a mesh into a grid.
#include "csg/build_grid.h"

#include <new>
#include <utility>

#include "csg/grid_of_faces.h"
#include "csg/solidify.h"
#include "csg/unite_thin.h"
#include "kdmanifold/error.h"
#include "kdmanifold/options.h"
#include "kdmanifold/thicken.h"
#include "mesh/progress.h"
#include "prepare/input_faces.h"

namespace kdm {

Grid build_grid(const Mesh& mesh, const BuildOptions& options, const Progress& progress) {
  return build_grid_within(mesh, options, 1, progress);
}

Grid build_grid_within(const Mesh& mesh, const BuildOptions& options, double share,
                       const Progress& progress) try {
  check_options(options);
  report_progress(progress, 0.0, "prepare");
  const bool thickens_all = options.thicken > 0 && options.thicken_what == ThickenWhat::kAll;
  InputFaces faces = prepare_faces(thickens_all ? thicken(mesh, options.thicken) : mesh, options);
  double threshold = 0;
  if (faces.repair && options.winding_threshold == 0 && goes_by_tolerance(options) &&
      some_part_is_closed(faces)) {
    threshold = solidify_open_parts(faces, options, part_of_progress(progress, 0, 0.05));
  }
  unite_thin_parts(faces, options, part_of_progress(progress, 0.05, 0.1));
  return grid_of_faces(std::move(faces), options, share, threshold, progress);
} catch (const std::bad_alloc&) {
  throw Error(ErrorCode::kOutOfMemory, "there is not enough memory to build the grid");
}

}  // namespace kdm
