// SPDX-License-Identifier: MIT
// Mesh -> kd-tree grid (paper section 5.1).
#pragma once

#include "kdmanifold/grid.h"
#include "kdmanifold/mesh.h"
#include "kdmanifold/progress.h"

namespace kdm {

/// How cells are split.
enum class SplitStrategy {
  kAdaptive,  ///< until the surface is met within the tolerance and its topology is resolved
  kOctree,    ///< the same, but at midpoints, x, y, z in turn
  kFeature,   ///< the same, through or near features of the cell (paper 5.1.2 (2))
  kMedian,    ///< paper 5.1.2 (1): median of triangle centres until every triangle is hit by a grid
              ///< edge
  kUniform    ///< midpoints in turn, to the full depth wherever a closed cell meets the surface
};

/// Which winding numbers are inside, or that there is no inside.
enum class InsideRule {
  kPositive,  ///< winding > 0: union of overlapping and nested shells
  kOdd,       ///< odd winding
  kNonzero,   ///< winding != 0
  kRepair,    ///< positive where the surface is closed and turned consistently; any other surface
              ///< becomes a solid by its generalised winding number (Jacobson et al. 2013)
  kSheet  ///< no solid: all of the surface is kept, as it is turned, and open surfaces stay open
          ///< (paper 2.3.2); the result is a manifold with boundary
};

/// How hits are linked where a minimal face carries more than two.
enum class Pairing {
  kTrace,    ///< follow the input's surface across the face (default)
  kHermite,  ///< least deviation from the hits' tangent lines, without crossings
  kInside,   ///< paper 2.1: link the two hits at the ends of an inside stretch of the outline
  kOutside   ///< paper 2.1: link the two hits at the ends of an outside stretch
};

struct BuildOptions {
  SplitStrategy strategy = SplitStrategy::kAdaptive;
  /// Adaptive, octree: how far the result may be from the input, in model units. Not negative;
  /// 0 takes `relative_tolerance` instead.
  double tolerance = 0;
  /// The same as a fraction of the diagonal of the input's bounding box. Not negative; 0 splits
  /// whatever is not plane down to the depth limit.
  double relative_tolerance = 0.001;
  /// Limit of the kd-tree's depth, 1 to 60; three levels halve a cell in each axis. 0 stands for
  /// 60, a safety net (18, 64 cells an axis, for uniform).
  int depth = 0;
  InsideRule inside = InsideRule::kRepair;
  /// `kRepair`: winding numbers above this are inside. Not negative, below 1; 0 stands for the one
  /// up to 0.5 that keeps most of the input's area. Lower closes wider gaps, and lets what bulges
  /// over them bulge further.
  double winding_threshold = 0;
  /// `kRepair`: holes wider than this (the diagonal of their bounding box, model units) are not
  /// closed but refused with `kNotClosed`. Not negative; 0 closes all.
  double largest_hole = 0;
  Pairing pairing = Pairing::kTrace;
  /// Takes the input for a surface that bounds nothing and builds the shell of this thickness
  /// around it (`thicken`), in model units. Not negative; 0 builds the input itself.
  double thicken = 0;
};

/// Builds the grid of a closed, consistently oriented mesh (after joining vertices of exactly
/// equal position); overlapping, nested and self-intersecting shells are welcome. As a sheet any
/// mesh will do: it comes apart where neighbours are turned against each other. Any mesh will do as
/// well if it is thickened; the grid's input report then is that of the shell. Linear in the
/// triangles times the depth. Throws `kInvalidMesh`, `kInvalidOption`, `kNotClosed`, `kAborted`.
Grid build_grid(const Mesh& mesh, const BuildOptions& options = {}, const Progress& progress = {});

}  // namespace kdm
