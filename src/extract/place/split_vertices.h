// SPDX-License-Identifier: MIT
// Splits vertices where a leaf holds more than one feature (paper 2.3.1).
#pragma once

#include "extract/dual/edit_log.h"
#include "extract/dual/grid_view.h"
#include "extract/dual/scope.h"
#include "extract/place/face_settings.h"

namespace kdm {

/// Splits each of the vertices that lies further off the planes of its hits than the error of the
/// settings: its ring is cut into sections, and each section gets a vertex that lies near the
/// planes of its hits. Vertices on the boundary stay. Returns the number of vertices added; each
/// brings two triangles.
Index split_vertices(const GridView& view, const FaceSettings& settings, DualMesh& mesh,
                     EditLog& log, const Scope& vertices = {});

}  // namespace kdm
