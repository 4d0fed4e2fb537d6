// SPDX-License-Identifier: MIT
// A result that does not meet itself.
#pragma once

#include <functional>

#include "extract/refine.h"

namespace kdm {

/// What `embed` did and what it left.
struct Embedding {
  DualMesh mesh;
  Index refined_hits = 0;       ///< that got a vertex
  std::uint64_t crossings = 0;  ///< pairs of triangles that still cross or touch
};

/// Makes the mesh again and again, with more detail wherever its triangles cross, touch or have no
/// area, until none do or there is nothing left to add. `loops` is the mesh with its loops found,
/// `make` makes the result from it.
Embedding embed(const GridData& grid, const DualMesh& loops,
                const std::function<DualMesh(const Details&)>& make);

}  // namespace kdm
