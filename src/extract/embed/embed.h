// SPDX-License-Identifier: MIT
// A result that does not meet itself.
#pragma once

#include <functional>

#include "extract/dual/embed_level.h"
#include "extract/dual/grid_view.h"
#include "extract/embed/restore.h"

namespace kdm {

/// What `embed` did and what it left.
struct Embedding {
  Index refined_hits = 0;       ///< that got a vertex
  std::uint64_t crossings = 0;  ///< pairs of triangles that still cross or touch
};

/// How `embed` has the mesh changed.
struct EmbedSteps {
  /// Moves a loop's vertex as this level asks for, in `loops`.
  std::function<void(DualMesh& loops, Index loop, EmbedLevel level)> move;
  /// Does to the part, in which the mesh is as the loops are, what the levels ask for. Without a
  /// part: to all.
  std::function<void(const EmbedLevels& levels, const Restored* part, DualMesh& mesh)> make;
  /// Called before every round.
  std::function<void(int round)> report;
};

/// Makes the mesh, and parts of it again and again at higher levels, wherever its triangles cross,
/// touch or have no area, until none do or there is nothing left to add. `loops` is the mesh with
/// its loops found, `mesh` a copy. All coordinates are rounded to what 32 bits in model units hold.
Embedding embed(const GridView& view, double margin, const EmbedSteps& steps, DualMesh& loops,
                DualMesh& mesh);

}  // namespace kdm
