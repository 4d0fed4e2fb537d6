// SPDX-License-Identifier: MIT
// Holds the options for the faces of the result.
#pragma once

#include <limits>

#include "grid/grid_data.h"
#include "kdmanifold/extract.h"

namespace kdm {

/// How far a vertex may lie from the plane of one of its hits before it is split: the larger of two
/// limits.
struct SplitError {
  double distance = std::numeric_limits<double>::infinity();  ///< lattice units
  double of_hits = 0;  ///< fraction of the distance to the furthest of its hits
};

/// Returns the limits by default. Where the surface is merely curved, a leaf's vertex lies a little
/// off its planes, and splits would fold it: only what looks like a second feature is split.
inline SplitError standard_split_error(const GridData& grid) {
  constexpr double kFeature = 0.3;
  return {grid.tolerance, kFeature};
}

/// The options of extraction that the passes from loops to faces need, in lattice units.
struct FaceSettings {
  SplitError split_error;
  double link_error = 0;  ///< how far an edge may pass from the surface between two leaves
  VertexPosition position = VertexPosition::kConstrained;
  bool quads = false;        ///< pairs of triangles become quads: nothing is refined or flipped
  bool two_manifold = true;  ///< doubled edges are separated
  bool unfold = true;        ///< folded and thin triangles are flipped
};

}  // namespace kdm
