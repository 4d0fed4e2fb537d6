// SPDX-License-Identifier: MIT
// One pass over a workpiece: from all its triangles down to the last level.
#pragma once

#include <vector>

#include "kdmanifold/mesh.h"
#include "kdmanifold/progress.h"
#include "mesh/marks.h"
#include "reduce/workpiece.h"

namespace kdm {

/// The mesh at some point of a pass.
struct PassLevel {
  Mesh mesh;                       ///< coordinates of about 1
  std::vector<VertexId> vertices;  ///< which vertex of the piece each of the mesh's is
  std::vector<Index> groups;       ///< per triangle, or empty
};

/// What a pass made.
struct Pass {
  std::vector<PassLevel> levels;  ///< one for each number of triangles
  Index collapses = 0;
  Index flips = 0;
};

/// Collapses edges until the numbers of triangles are reached, one after the other, or no edge can
/// be collapsed any more. If a distance is kept, false creases are flipped before and, for the last
/// level, afterwards.
Pass run_pass(Workpiece& piece, const std::vector<Index>& targets, const Progress& progress);

/// Marks the vertices of the piece, as it was before the pass, of which the corners came of
/// triangles that meet others or have no area, on any level.
Marks vertices_that_meet(const Workpiece& piece, const std::vector<PassLevel>& levels);

}  // namespace kdm
