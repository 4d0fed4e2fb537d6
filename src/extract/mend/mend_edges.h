// SPDX-License-Identifier: MIT
// The passes that make a 2-manifold index mesh with few folds of a mesh with all its vertices.
#pragma once

#include <vector>

#include "extract/dual/edit_log.h"
#include "extract/dual/embed_level.h"
#include "extract/dual/grid_view.h"
#include "extract/place/face_settings.h"

namespace kdm {

/// A part of a mesh that was made anew.
struct RemadePart {
  const std::vector<HitId>& hits;    ///< whose triangles were made anew; ascending
  const std::vector<LoopId>& loops;  ///< all of theirs; ascending
  VertexId first_vertex = 0;         ///< it and all after it are new
  TriangleId first_triangle = 0;     ///< the same
};

/// Separates double edges (see `separate_double_edges`) and flips edges of folded and thin
/// triangles (see `unfold`), as far as the settings ask, in the whole mesh.
void mend_edges(const GridView& view, const FaceSettings& settings, const EmbedLevels& levels,
                DualMesh& mesh, EditLog& log);

/// Does the same in a part: at the edges of its loops and of new vertices, and among its hits'
/// triangles, those of touched hits and new ones.
void mend_edges(const GridView& view, const FaceSettings& settings, const EmbedLevels& levels,
                DualMesh& mesh, EditLog& log, const RemadePart& part);

}  // namespace kdm
