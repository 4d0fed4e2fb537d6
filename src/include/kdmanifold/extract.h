// SPDX-License-Identifier: MIT
// Extracts a 2-manifold mesh from a kd-tree grid (paper sections 2 and 3.3).
#pragma once

#include <optional>

#include "kdmanifold/grid.h"
#include "kdmanifold/mesh.h"
#include "kdmanifold/progress.h"
#include "kdmanifold/warnings.h"

namespace kdm {

/// What the result must be as an index mesh.
enum class Strict {
  kOff,  ///< the raw dual surface: its half-edges are manifold, but edges and vertices of different
         ///< parts may share numbers
  kManifold,  ///< 2-manifold: vertices are added where two parts of the surface would share an
              ///< edge, parts without volume are dropped
  kEmbedded   ///< the same, and no two triangles cross or touch but where they share vertices, and
              ///< none is without area. Holds for the coordinates rounded to 32 bits, which the
              ///< result has, so vertices may be told by their positions alone, as in STL
              ///< files. Not with `quads`, which come out as by `kManifold`
};

/// Where a vertex goes if the best place for it lies outside of its leaf. The best place is where
/// the sum of squared distances to the planes of its hits is least (paper 2.2.1).
enum class VertexPosition {
  kConstrained,  ///< to the best place within the leaf
  kProjection    ///< to the point of the leaf that is nearest to the best place
};

/// Which parts of the result are kept. In any case crumbs go: parts thinner than the tolerance
/// beside holes that were closed.
enum class Parts {
  kAll,     ///< all
  kOuter,   ///< only parts that lie in no other: no cavities, and nothing within cavities
  kLargest  ///< only the part that encloses most, without its cavities
};

/// What `extract` can be told. Each default serves; `options.h` describes the same members for
/// programs.
struct ExtractOptions {
  /// Joins the two triangles of an edge where four leaves meet to one quad (all of them on a
  /// uniform grid). Quads need not be planar.
  bool quads = false;
  /// Splits vertices that lie further than this from a plane they stand for, in model units, so
  /// that a leaf can hold several features (paper 2.3.1). Not negative; more than the model's size,
  /// infinity included, splits none. 0 splits vertices that are further off than the grid's
  /// tolerance and 0.3 times the distance to the furthest of their hits, but none with `quads`.
  double split_error = 0;
  /// Where vertices go whose best place lies outside of their leaf.
  VertexPosition position = VertexPosition::kConstrained;
  /// Flips edges of triangles that are folded over their neighbours, where that lays them flat, and
  /// of thin triangles (with an angle below two degrees), where that makes their smallest angle
  /// twice as wide. Takes away most self-intersections and most thin triangles. Not with `quads`.
  bool unfold = true;
  /// Puts a vertex where an edge passes from one leaf to another further from the surface than
  /// this, in model units. Not negative; more than the model's size, infinity included, puts none.
  /// 0 stands for the grid's tolerance. Not with `quads`.
  double link_error = 0;
  /// What the result must be as an index mesh.
  Strict strict = Strict::kEmbedded;
  /// Which parts of the result are kept. Sheets keep all.
  Parts parts = Parts::kAll;
  /// Leaves out parts smaller than this, with what lies in them. The size of a part is the diagonal
  /// of its bounding box, in model units; a part within a cavity is one like any other. Not
  /// negative; 0 leaves out none. Not for sheets.
  double drop_parts = 0;
  /// Fills cavities smaller than this, with what lies in them; their size is measured as that of
  /// parts. Not negative; 0 fills none. Not for sheets.
  double drop_cavities = 0;
  /// Removes handles smaller than this: tunnels are closed by a wall, bridges cut through, at their
  /// narrowest place. The size of a handle is the length of the shortest closed path on the surface
  /// that goes round it or through its tunnel, along edges, in model units: of a round hole its
  /// circumference. Not negative; 0 removes none. Not for sheets, nor with `quads`, nor with
  /// `strict` off.
  double drop_handles = 0;
  /// Gives every corner of the faces a normal for shading, from the input's normals at the hits.
  /// The mesh itself stays the same: vertices on a crease are not doubled.
  bool normals = false;
  /// With `normals`: where the normals of neighbouring faces turn by more than this there is a
  /// crease, and their corners keep different normals. Degrees, from 0 (creases everywhere but in
  /// flat parts) to 180 (no crease at all).
  double crease_angle = 30;
};

/// How the mesh was made.
struct ExtractReport {
  Index dropped_pillows = 0;    ///< parts without volume that were left out
  Index inserted_vertices = 0;  ///< vertices added to keep edges apart
  Index split_vertices = 0;     ///< vertices added for further features of a leaf
  Index link_vertices = 0;      ///< vertices added between leaves and at hits
  Index flipped_edges = 0;      ///< edges flipped, of triangles that were folded over or thin
  Index refined_hits = 0;       ///< `kEmbedded`: hits that got vertices so that nothing crosses
  /// With `kEmbedded` the number of pairs of triangles that still cross or touch, and of triangles
  /// without area: 0, unless parts are nearer to each other than 32 bits tell apart, or sheets
  /// cross. Otherwise empty, because crossing pairs are not searched for.
  std::optional<std::uint64_t> crossings;
  Index dropped_parts = 0;        ///< parts left out because of the option `parts`
  Index small_parts = 0;          ///< parts left out because of `drop_parts`, with what lay in them
  double small_parts_volume = 0;  ///< volume that was taken away with them, in cubic model units
  Index small_cavities = 0;  ///< cavities filled because of `drop_cavities`, with what lay in them
  double small_cavities_volume = 0;  ///< volume that was filled with them, in cubic model units
  Index small_handles = 0;           ///< handles removed because of `drop_handles`
  /// Handles smaller than `drop_handles` that are still there, since nothing closes them without
  /// meeting the surface.
  Index kept_handles = 0;
  Index dropped_crumbs = 0;  ///< parts thinner than the tolerance, beside closed holes, left out
  /// Area, in square model units, of the faces that stand for no input face but close a hole. Their
  /// entry in `source_faces` is kNone.
  double invented_area = 0;
  Index boundary_loops = 0;  ///< closed walks along the boundary; only sheets have one
};

/// A mesh with the account of how it was made.
struct ExtractedMesh : Mesh {
  ExtractReport report;
  /// What one should know before one trusts the mesh, of input and grid too; the gravest first.
  std::vector<Warning> warnings;
};

/// Makes the surface of the grid, which stays as it is. The result is closed, oriented outwards and
/// 2-manifold (unless `strict` is `kOff`); of a sheet it is a 2-manifold with boundary, turned as
/// the input is. The time grows linearly with the hits. Throws `kInvalidOption` (see
/// `check_options`), `kAborted` and `kOutOfMemory`; and, if nothing is left, `kNotClosed` of an
/// input that had to be repaired, `kEmptyResult` of any other: the tolerance was too wide, or the
/// depth too small.
ExtractedMesh extract(const Grid& grid, const ExtractOptions& options = {},
                      const Progress& progress = {});

}  // namespace kdm
