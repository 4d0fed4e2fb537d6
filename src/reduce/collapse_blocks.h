// SPDX-License-Identifier: MIT
// Collapses edges in many blocks of space, each by itself: threads share them, and what a block's
// steps look at stays in the processor's caches.
#pragma once

#include <functional>

#include "reduce/collapser.h"
#include "reduce/workpiece.h"

namespace kdm {

/// How many steps were taken in all blocks.
struct BlockSteps {
  Index collapses = 0;
  Index flips = 0;
};

/// Tells whether the mesh is large enough for several blocks. Without a distance kept, or with
/// groups of faces, it is not cut.
bool is_worth_blocks(const Workpiece& piece);

/// Flips false creases, then collapses edges, wherever all that a step changes lies in one block;
/// does so again with other blocks while the mesh is worth it. What is left to do is between blocks
/// of the last time. The blocks follow from the mesh alone, so the result does not depend on the
/// number of threads. `state` is what is known before and afterwards. Calls `report` on the calling
/// thread from time to time, with the number of triangles that have gone by then; what it throws
/// stops the work.
BlockSteps collapse_in_blocks(Workpiece& piece, CollapseState& state,
                              const std::function<void(Index gone)>& report);

}  // namespace kdm
