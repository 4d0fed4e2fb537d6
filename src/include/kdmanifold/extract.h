// SPDX-License-Identifier: MIT
// kd-tree grid -> 2-manifold mesh (paper sections 2 and 3.3).
#pragma once

#include <optional>

#include "kdmanifold/grid.h"
#include "kdmanifold/mesh.h"
#include "kdmanifold/progress.h"

namespace kdm {

/// What the result must be as an index mesh.
enum class Strict {
  kOff,       ///< the raw dual surface, whose half-edges are manifold but not its vertex numbers
  kManifold,  ///< 2-manifold: vertices keep edges apart that two parts of the surface would share,
              ///< parts without volume are dropped
  /// The same, and no two triangles cross or touch but where they share vertices, none is without
  /// area. Coordinates are rounded to 32 bits and it holds for these. Not with `quads`.
  kEmbedded
};

/// Where a vertex goes if the best place for it lies outside of its leaf (paper 2.2.1).
enum class VertexPosition {
  kConstrained,  ///< where the squared distances to its planes are least within the leaf (default)
  kProjection    ///< to the point of the leaf that is nearest to the best place
};

/// Which parts of the result are kept.
enum class Parts {
  kAll,     ///< all but crumbs: slivers thinner than the tolerance beside holes that were closed
  kOuter,   ///< only those that lie in no other: no cavities, and nothing within cavities
  kLargest  ///< only the one that encloses most, without its cavities
};

struct ExtractOptions {
  /// Join the two triangles of an edge where four leaves meet to one quad (all of them on a
  /// uniform grid). Quads need not be planar.
  bool quads = false;
  /// Split vertices that lie further than this from a plane they stand for, in model units, so that
  /// a leaf can hold several features (paper 2.3.1). Not negative; more than the model's size:
  /// never. 0: where they are further off than the grid's tolerance and 0.3 times the way to the
  /// furthest of their hits, but never with `quads`.
  double split_error = 0;
  /// How vertices are kept within their leaves.
  VertexPosition position = VertexPosition::kConstrained;
  /// Flip edges of triangles that are folded over their neighbours, where that lays them flat, and
  /// of thin ones (an angle below two degrees), where that makes their smallest angle twice as
  /// wide. Takes away most self-intersections and most thin triangles. Not with `quads`.
  bool unfold = true;
  /// Put a vertex where an edge passes from one leaf to another further from the surface than
  /// this, in model units. Not negative; more than the model's size: never. 0: the grid's
  /// tolerance. Not with `quads`.
  double link_error = 0;
  Strict strict = Strict::kManifold;
  /// Leave parts out. Not of sheets.
  Parts parts = Parts::kAll;
  /// Give every corner of the faces a normal for shading, from the input's normals at the hits. The
  /// mesh stays what it is: vertices on a crease are not doubled.
  bool normals = false;
  /// Where the normals of neighbouring faces turn by more than this there is a crease and their
  /// corners keep different normals; degrees, 0 (all but flat parts) to 180 (no crease at all).
  /// With `normals` only.
  double crease_angle = 30;
};

struct ExtractReport {
  Index dropped_pillows = 0;    ///< parts without volume that were left out
  Index inserted_vertices = 0;  ///< vertices added to keep edges apart
  Index split_vertices = 0;     ///< vertices added for further features of a leaf
  Index link_vertices = 0;      ///< vertices added between leaves and at hits
  Index flipped_edges = 0;      ///< of triangles that were folded over or thin
  Index refined_hits = 0;       ///< `kEmbedded`: hits that got vertices so that nothing crosses
  /// With `kEmbedded` the number of pairs of triangles that still cross or touch: 0, unless parts
  /// are nearer to each other than 32 bits tell apart, or sheets cross. Otherwise empty, because
  /// crossing pairs are not searched for.
  std::optional<std::uint64_t> crossings;
  Index dropped_parts = 0;   ///< left out as `parts` asks
  Index dropped_crumbs = 0;  ///< slivers beside closed holes that were left out
  double invented_area = 0;  ///< of the faces that are of no input face but close it; their entry
                             ///< of `source_faces` is kNone
  Index boundary_loops = 0;  ///< closed walks along the boundary; only sheets have one
};

/// A mesh with the account of how it was made.
struct ExtractedMesh : Mesh {
  ExtractReport report;
};

/// The surface of the grid: closed, oriented outwards, 2-manifold. Of a sheet: a 2-manifold with
/// boundary, turned as the input is. Linear in the hits. Throws `kNotClosed` if nothing comes out
/// of an input that had to be repaired, `kInvalidOption`, `kAborted`.
ExtractedMesh extract(const Grid& grid, const ExtractOptions& options = {},
                      const Progress& progress = {});

}  // namespace kdm
