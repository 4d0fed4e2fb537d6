// SPDX-License-Identifier: MIT
// A result that does not meet itself.
#pragma once

#include <cstdint>
#include <span>

#include "extract/dual/edit_log.h"
#include "extract/dual/grid_view.h"
#include "extract/place/face_settings.h"
#include "kdmanifold/progress.h"

namespace kdm {

/// A mesh whose triangles do not meet, and what was done to it.
struct Embedding {
  DualMesh mesh;
  EditLog log;
  Index refined_hits = 0;       ///< that got a vertex
  std::uint64_t crossings = 0;  ///< pairs of triangles that still cross or touch
};

/// Makes a mesh of `loops`, one triangle a hit and one vertex a loop, by the same passes as without
/// embedding, and makes parts of it again at higher levels wherever its triangles cross, touch or
/// have no area, until none do or there is nothing left to add. `missed` are the vertices that
/// `place_vertices` returned. All coordinates of the result are rounded to what 32 bits in model
/// units hold. Reports its rounds as 0.7 to 0.9 of the whole.
Embedding embed(const GridView& view, const FaceSettings& settings, std::span<const LoopId> missed,
                const Progress& progress, DualMesh loops);

}  // namespace kdm
