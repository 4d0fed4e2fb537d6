// SPDX-License-Identifier: MIT
#include "csg/rough_look.h"

#include "csg/grid_of_faces.h"
#include "kdmanifold/extract.h"
#include "prepare/input_faces.h"

namespace kdm {

Mesh look_roughly(const InputFaces& faces, const BuildOptions& options, const Progress& progress) {
  constexpr double kRoughness = 4;
  BuildOptions rough = options;
  rough.tolerance = kRoughness * tolerance_of(options, faces.report.extent);
  rough.relative_tolerance = BuildOptions().relative_tolerance;  // which does not count
  rough.minimum_thickness = rough.minimum_gap = 0;
  return extract(grid_of_faces(faces, rough, 1, 0, progress), {.strict = Strict::kManifold});
}

}  // namespace kdm
