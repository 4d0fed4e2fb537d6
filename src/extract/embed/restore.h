// SPDX-License-Identifier: MIT
// Taking back what was done to a part of a dual mesh.
#pragma once

#include "extract/dual/edit_log.h"

namespace kdm {

struct Restored {
  std::vector<Index> hits;   ///< ascending
  std::vector<Index> loops;  ///< all of theirs; ascending
  std::vector<Index> cut;    ///< those that had been split; ascending
};

/// Makes the triangles of these hits, and of all that divisions, splits and flips have tied to
/// them, again what they are in `loops`, from which the mesh was made: one triangle a hit. Vertices
/// and triangles that were added there are dropped.
Restored restore(const DualMesh& loops, const std::vector<Index>& hits, DualMesh& mesh,
                 EditLog& log);

}  // namespace kdm
