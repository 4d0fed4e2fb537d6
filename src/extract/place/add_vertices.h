// SPDX-License-Identifier: MIT
// Runs the passes that add vertices to a mesh that has one vertex for each loop.
#pragma once

#include <span>

#include "extract/dual/edit.h"
#include "extract/dual/edit_log.h"
#include "extract/dual/embed_level.h"
#include "extract/dual/grid_view.h"
#include "extract/dual/scope.h"
#include "extract/place/face_settings.h"

namespace kdm {

/// Splits those of the `missed` vertices that are loops of level `kTriangle` (see
/// `split_vertices`), then adds vertices between leaves, and at hits whose levels demand them (see
/// `refine`). `hits` limits this to a list of hits; `one_sided` are the vertices that others have
/// on links to these. The listed hits, and all hits round the missed vertices, must have one
/// triangle each.
void add_vertices(const GridView& view, const FaceSettings& settings, const EmbedLevels& levels,
                  std::span<const LoopId> missed, DualMesh& mesh, EditLog& log,
                  const Scope& hits = {}, std::span<const OneSidedVertex> one_sided = {});

}  // namespace kdm
