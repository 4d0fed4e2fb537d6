// SPDX-License-Identifier: MIT
// Runs the passes that come after all vertices are added: they make the mesh a 2-manifold index
// mesh with few folds.
#pragma once

#include <vector>

#include "extract/dual/edit_log.h"
#include "extract/dual/embed_level.h"
#include "extract/dual/grid_view.h"
#include "extract/place/face_settings.h"

namespace kdm {

/// A part of a mesh that was made anew.
struct RemadePart {
  const std::vector<HitId>& hits;         ///< whose triangles were made anew; ascending
  const std::vector<VertexId>& vertices;  ///< the corners of these triangles that are not new
  VertexId first_vertex = 0;              ///< this vertex and all after it are new
  TriangleId first_triangle = 0;          ///< this triangle and all after it are new
};

/// Separates double edges (see `separate_double_edges`) and flips edges of folded and thin
/// triangles (see `unfold`), as far as the settings ask, in the whole mesh.
void mend_edges(const GridView& view, const FaceSettings& settings, const EmbedLevels& levels,
                DualMesh& mesh, EditLog& log);

/// Does the same in a part: at the edges of its vertices and of new ones, and among the triangles
/// of its hits and of touched hits (see `EditLog::touched_hits`) and the new ones.
void mend_edges(const GridView& view, const FaceSettings& settings, const EmbedLevels& levels,
                DualMesh& mesh, EditLog& log, const RemadePart& part);

}  // namespace kdm
