// SPDX-License-Identifier: MIT
// Splits vertices first, then adds vertices at links and hits.
#include "extract/place/add_vertices.h"

#include <algorithm>
#include <iterator>
#include <vector>

#include "extract/place/refine.h"
#include "extract/place/split_vertices.h"

namespace kdm {

void add_vertices(const GridView& view, const FaceSettings& settings, const EmbedLevels& levels,
                  std::span<const LoopId> missed, DualMesh& mesh, EditLog& log, const Scope& hits,
                  std::span<const OneSidedVertex> one_sided) {
  std::vector<LoopId> plain;
  std::copy_if(missed.begin(), missed.end(), std::back_inserter(plain),
               [&](LoopId v) { return levels.of_loop(v) == EmbedLevel::kTriangle; });
  split_vertices(view, settings, mesh, log, plain);
  if (!settings.quads) refine(view, levels, settings.link_error, mesh, log, hits, one_sided);
}

}  // namespace kdm
