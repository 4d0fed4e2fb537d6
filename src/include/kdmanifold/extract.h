// SPDX-License-Identifier: MIT
// kd-tree grid -> 2-manifold mesh (paper sections 2 and 3.3).
#pragma once

#include "kdmanifold/grid.h"
#include "kdmanifold/mesh.h"
#include "kdmanifold/progress.h"

namespace kdm {

struct ExtractOptions {
  /// Join the two triangles of an edge where four leaves meet to one quad (all of them on a
  /// uniform grid). Quads need not be planar.
  bool quads = false;
  /// Split vertices that lie further than this from a plane they stand for, in model units, so that
  /// a leaf can hold several features (paper 2.3.1). Not negative; more than the model's size:
  /// never. 0: where they are further off than the grid's tolerance and 0.3 times the way to the
  /// furthest of their hits, but never with `quads`.
  double split_error = 0;
  /// Flip edges of triangles that are folded over their neighbours, where that lays them flat.
  /// Takes away most self-intersections. Not with `quads`.
  bool unfold = true;
  /// Make the result 2-manifold as an index mesh: insert a vertex where two parts of the surface
  /// would share an edge, drop parts without volume. Off: the raw dual surface, whose half-edges
  /// are manifold but whose vertex numbers may not show it.
  bool strict = true;
};

struct ExtractReport {
  Index dropped_pillows = 0;    ///< parts without volume that were left out
  Index inserted_vertices = 0;  ///< vertices added to keep edges apart
  Index split_vertices = 0;     ///< vertices added for further features of a leaf
  Index flipped_edges = 0;      ///< of triangles that were folded over
  Index boundary_loops = 0;     ///< closed walks along the boundary; only sheets have one
};

/// A mesh with the account of how it was made.
struct ExtractedMesh : Mesh {
  ExtractReport report;
};

/// The surface of the grid: closed, oriented outwards, 2-manifold. Of a sheet: a 2-manifold with
/// boundary, turned as the input is. Linear in the hits.
ExtractedMesh extract(const Grid& grid, const ExtractOptions& options = {},
                      const Progress& progress = {});

}  // namespace kdm
