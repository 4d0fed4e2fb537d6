// SPDX-License-Identifier: MIT
// Takes back what was done to a part of a dual mesh.
#pragma once

#include <vector>

#include "extract/dual/edit_log.h"

namespace kdm {

/// The part of a mesh that was taken back.
struct Restored {
  std::vector<HitId> hits;    ///< each has one triangle again; ascending
  std::vector<LoopId> loops;  ///< all loops round which these hits are; ascending
  std::vector<LoopId> split;  ///< the loops from which vertices had been split off; ascending
};

/// Makes the triangles of these hits again what they are in `loops`, from which `mesh` was made:
/// one triangle a hit, with its links and its loops' vertices. The same is done to all hits whose
/// triangles were changed together with the triangles of these hits, and to the hits round other
/// loops in the same leaves. Vertices and triangles that were added there are dropped; what was
/// noted in `log` about these hits and loops is forgotten. Takes time for the hits, and for one
/// pass over all triangles.
Restored restore(const DualMesh& loops, const std::vector<HitId>& hits, DualMesh& mesh,
                 EditLog& log);

}  // namespace kdm
