// SPDX-License-Identifier: MIT
// Looks at what winding numbers make of open faces, before time is spent on it.
#pragma once

#include "kdmanifold/build.h"
#include "kdmanifold/mesh.h"
#include "kdmanifold/progress.h"
#include "prepare/faces.h"

namespace kdm {

/// Builds and extracts prepared faces within four times the tolerance of the options, in a
/// sixteenth of the time or less. Triangles may cross. Throws `kNotClosed` or `kEmptyResult` if the
/// faces enclose nothing so wide.
Mesh look_roughly(const InputFaces& faces, const BuildOptions& options, const Progress& progress);

}  // namespace kdm
