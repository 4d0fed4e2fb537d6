// SPDX-License-Identifier: MIT
// Builds the grid of faces that are prepared.
#pragma once

#include "kdmanifold/build.h"
#include "prepare/faces.h"

namespace kdm {

/// Builds a grid of prepared faces, with cells that meet the surface within `share` (above 0, at
/// most 1) of the tolerance. Nothing more is sewn, patched or turned. `threshold` is the winding
/// number above which points were inside when open parts became solids (see csg/solidify.h); 0 if
/// that was not asked. Faces that are not closed are told inside from outside by winding numbers.
Grid grid_of_faces(InputFaces faces, const BuildOptions& options, double share, double threshold,
                   const Progress& progress);

}  // namespace kdm
