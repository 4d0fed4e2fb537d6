// SPDX-License-Identifier: MIT
// Mesh -> kd-tree grid (paper section 5.1).
#pragma once

#include "kdmanifold/grid.h"
#include "kdmanifold/mesh.h"
#include "kdmanifold/progress.h"

namespace kdm {

/// How cells are split. All end at `BuildOptions::depth` at the latest.
enum class SplitStrategy {
  kUniform,  ///< midpoints, x, y, z in turn, to the full depth wherever a closed cell meets the surface
  kOctree,   ///< the same, but a cell whose surface is one plane section is left whole
  kMedian    ///< paper 5.1.2 (1): median of triangle centres until every triangle is hit by a grid edge
};

/// Which winding numbers are inside.
enum class InsideRule {
  kPositive,  ///< winding > 0: union of overlapping and nested shells
  kOdd,       ///< odd winding
  kNonzero    ///< winding != 0
};

/// How hits are linked where a minimal face carries more than two.
enum class Pairing {
  kTrace,    ///< follow the input's surface across the face (default)
  kHermite,  ///< least deviation from the hits' tangent lines, without crossings
  kInside,   ///< paper 2.1: link the two hits at the ends of an inside stretch of the outline
  kOutside   ///< paper 2.1: link the two hits at the ends of an outside stretch
};

struct BuildOptions {
  SplitStrategy strategy = SplitStrategy::kOctree;
  int depth = 21;  ///< limit of the kd-tree's depth, 1 to 60; three levels halve a cell in each axis
  InsideRule inside = InsideRule::kPositive;
  Pairing pairing = Pairing::kTrace;
};

/// Builds the grid of a closed, consistently oriented mesh (after joining vertices of exactly
/// equal position); overlapping, nested and self-intersecting shells are welcome. Linear in the
/// triangles times the depth. Throws `kInvalidMesh`, `kInvalidOption`, `kNotClosed`, `kAborted`.
Grid build_grid(const Mesh& mesh, const BuildOptions& options = {}, const Progress& progress = {});

}  // namespace kdm
