// SPDX-License-Identifier: MIT
// The passes that add vertices to a mesh of one vertex a loop.
#pragma once

#include <span>

#include "extract/dual/edit_log.h"
#include "extract/dual/embed_level.h"
#include "extract/dual/grid_view.h"
#include "extract/dual/scope.h"
#include "extract/place/face_settings.h"

namespace kdm {

/// Splits those of the `missed` vertices that are loops of level `kTriangle` (see
/// `split_vertices`), then adds vertices between leaves, and at hits as their levels ask (see
/// `refine`). In the scope, a list of hits, the mesh has one triangle a hit; so have all hits round
/// the missed vertices.
void add_vertices(const GridView& view, const FaceSettings& settings, const EmbedLevels& levels,
                  std::span<const LoopId> missed, DualMesh& mesh, EditLog& log,
                  const Scope& hits = {});

}  // namespace kdm
