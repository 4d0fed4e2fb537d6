// SPDX-License-Identifier: MIT
// Makes a mesh that does not cross or touch itself.
#pragma once

#include <cstdint>
#include <span>

#include "extract/dual/edit_log.h"
#include "extract/dual/grid_view.h"
#include "extract/place/face_settings.h"
#include "kdmanifold/progress.h"

namespace kdm {

/// A mesh whose triangles have nothing in common but the corners and sides that they share.
struct Embedding {
  DualMesh mesh;
  EditLog log;                  ///< what was done to the mesh since its loops were found
  Index refined_hits = 0;       ///< number of hits above level `kTriangle`
  std::uint64_t crossings = 0;  ///< pairs of triangles that still cross or touch, and triangles
                                ///< without area; 0 but for rare input, such as solids that touch
                                ///< themselves along an edge
};

/// Makes a mesh that does not cross or touch itself from `loops`, the mesh with one triangle for
/// each hit and one vertex for each loop.
///
/// First makes the same mesh as without embedding. Then looks for triangles that cross or touch
/// others or have no area, raises the levels of their hits (embed_level.h), makes the mesh anew
/// there, and repeats this until there are no such triangles, or all of their hits have the highest
/// level. Most hits keep their one triangle.
///
/// `missed` are the loops whose vertices miss planes of their hits, as `place_vertices` returns
/// them. All coordinates of the result are 32-bit floats once they are converted to model units, so
/// writing them as such rounds nothing. Tells `progress` fractions from 0.7 to 0.9.
Embedding embed(const GridView& view, const FaceSettings& settings, std::span<const LoopId> missed,
                const Progress& progress, DualMesh loops);

}  // namespace kdm
