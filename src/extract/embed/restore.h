// SPDX-License-Identifier: MIT
// Takes back what was done to a part of a dual mesh.
#pragma once

#include <vector>

#include "extract/dual/edit.h"
#include "extract/dual/edit_log.h"
#include "extract/dual/embed_level.h"

namespace kdm {

/// The part of a mesh that was taken back.
struct Restored {
  std::vector<HitId> hits;    ///< each has one triangle again; ascending
  std::vector<LoopId> loops;  ///< all loops round which these hits are; ascending
  std::vector<LoopId> split;  ///< the loops from which vertices had been split off; ascending
  /// The links' vertices that triangles beyond the part keep; ascending by `half_edge`, which is
  /// one of the part.
  std::vector<OneSidedVertex> one_sided;
};

/// Makes the triangles of these hits again what they are in `loops`, from which `mesh` was made:
/// one triangle a hit, with its links and its loops' vertices. The same is done to all hits whose
/// triangles were changed together with the triangles of these hits, and to the hits round other
/// loops in the same leaves if these loops are nested. `levels` are what the mesh was made at, or
/// higher; `hits` must name all hits whose level was raised or whose loops were. Vertices and
/// triangles that were added there are dropped, but for vertices of links that hits beyond the part
/// keep: the part must be divided there again (see `Division::side`). What was noted in `log` about
/// these hits and loops is forgotten. Takes time for the hits, and for one pass over all triangles.
Restored restore(const DualMesh& loops, const EmbedLevels& levels, const std::vector<HitId>& hits,
                 DualMesh& mesh, EditLog& log);

}  // namespace kdm
