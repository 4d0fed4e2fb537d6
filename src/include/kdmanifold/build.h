// SPDX-License-Identifier: MIT
// Builds a kd-tree grid from a mesh (paper section 5.1).
#pragma once

#include <array>
#include <optional>

#include "kdmanifold/grid.h"
#include "kdmanifold/mesh.h"
#include "kdmanifold/progress.h"

namespace kdm {

/// How cells are split (paper section 5.1.2).
enum class SplitStrategy {
  kAdaptive,  ///< until the surface is met within the tolerance and its topology is resolved
  kOctree,    ///< the same, but at midpoints, x, y, z in turn
  kFeature,   ///< the same, but through or near features of the cell (paper 5.1.2 (2))
  kMedian,    ///< at the median of triangle centres, until every triangle is hit by a grid edge
              ///< (paper 5.1.2 (1))
  kUniform    ///< at midpoints, x, y, z in turn, to the full depth wherever a cell, its sides
              ///< included, meets the surface
};

/// Which winding numbers are inside, or that there is no inside. All rules but `kRepair` and
/// `kSheet` demand a mesh that is closed and consistently oriented.
enum class InsideRule {
  kPositive,  ///< winding number > 0: the union of overlapping and nested shells
  kOdd,       ///< odd winding numbers
  kNonzero,   ///< winding number != 0
  kRepair,    ///< positive where the surface is closed, once parts that are inside out are turned;
              ///< any other surface is sewn and turned, its holes are closed by patches, and small
              ///< parts that bound nothing are left out; where much bounds nothing, the generalised
              ///< winding number tells inside from outside (Jacobson et al. 2013)
  kSheet  ///< no solid: all of the surface is kept, as it is turned, and open surfaces stay open
          ///< (paper 2.3.2); the result is a manifold with boundary
};

/// Which parts of a surface are given a thickness.
enum class ThickenWhat {
  kAll,    ///< all, whatever they bound
  kSheets  ///< those that bound nothing, also fins and ribs on solids, which stay as they are; of
           ///< `kRepair`
};

/// How hits are linked where a minimal face (the overlap of two leaves' sides) has more than two on
/// its outline.
enum class Pairing {
  kTrace,    ///< as the input's surface crosses the face
  kHermite,  ///< with the least deviation from the hits' tangent lines, without crossings
  kInside,   ///< paper 2.1: link the two hits at the ends of an inside stretch of the outline
  kOutside   ///< paper 2.1: link the two hits at the ends of an outside stretch of the outline
};

/// The lowest and the highest corner of a box: x, y, z and again x, y, z.
using BoxCorners = std::array<double, 6>;

/// Tells whether the numbers are finite and the corners those of a box, which may be flat but no
/// point.
bool is_box(const BoxCorners& corners);

/// What `build_grid` can be told. Each default serves; `options.h` describes the same members for
/// programs.
struct BuildOptions {
  SplitStrategy strategy = SplitStrategy::kAdaptive;
  /// How far the result may be from the input, in model units. For `kAdaptive`, `kOctree` and
  /// `kFeature`; the other strategies do not ask for it. Not negative; 0 means that
  /// `relative_tolerance` counts instead.
  double tolerance = 0;
  /// The same as a fraction of the diagonal of the input's bounding box. Not negative; 0 splits all
  /// that is not plane down to the depth limit.
  double relative_tolerance = 0.001;
  /// Limit of the kd-tree's depth, 1 to 60; three levels halve a cell in each axis. 0 stands for
  /// 60, which is reached nowhere but in hopeless places, or, for `kUniform`, for 18: 64 cells an
  /// axis.
  int depth = 0;
  /// Resolution of `kUniform` and `kOctree` in cells along the longest side of the input's bounding
  /// box, 1 to 500,000: any number, where a depth gives powers of two of a cube that is larger
  /// than the input. The octree's cells are as small as this wherever the surface is not plane. Not
  /// together with `depth` and the tolerances, which count where this is 0.
  int cells = 0;
  InsideRule inside = InsideRule::kRepair;
  /// For `kRepair`: winding numbers above this are inside. Not negative, below 1; at 0, patches
  /// close holes, and where that does not do, the number up to 0.5 counts that keeps most of the
  /// input's area. Above 0 there are no patches. Lower numbers close wider gaps, and let what
  /// bulges over the gaps bulge further.
  double winding_threshold = 0;
  /// For `kRepair`: holes wider than this are not closed but refused with `kNotClosed`. The width
  /// is the diagonal of the hole's bounding box, in model units. Not negative; 0 closes all holes.
  double largest_hole = 0;
  Pairing pairing = Pairing::kTrace;
  /// Builds the shell of this thickness around the surface (see `thicken`), in model units. Not
  /// negative, and not below four lattice steps, about a millionth of the model's extent; 0 builds
  /// the input itself.
  double thicken = 0;
  /// Which parts of the surface get that thickness.
  ThickenWhat thicken_what = ThickenWhat::kAll;
  /// Leaves out what of the solid is thinner than this, in model units; within the tolerance, and
  /// within a sixteenth of the thickness at most, it is left to chance. Up to 0.6 times the
  /// thickness stays of thin things where they end in something thicker, and edges of less than 54
  /// degrees become blunt. Not negative; 0 leaves out nothing. For the strategies that go by a
  /// tolerance, and the rules `kRepair` and `kPositive`; not for Boolean operations.
  double minimum_thickness = 0;
  /// Fills gaps, holes and cavities of the solid that are narrower than this, in the same way: it
  /// is the least thickness of what lies outside. After `minimum_thickness`.
  double minimum_gap = 0;
  /// The box over which the grid is laid, in model units; it must hold the model and have an
  /// extent. Grids that were laid over the same box can be merged (see `merge_grids`). If not set,
  /// it is the model's own bounding box. A box much larger than the model costs precision:
  /// positions are decided in steps of a millionth of its longest side.
  std::optional<BoxCorners> box = std::nullopt;
};

/// Builds the grid of a mesh after joining vertices of exactly equal position. What the mesh must
/// be depends on the options:
/// - `kRepair`, the default: any mesh that encloses something. It may be open, crossing itself or
///   turned inconsistently; a closed mesh whose parts look outwards is taken exactly as it is.
/// - `kPositive`, `kOdd`, `kNonzero`: closed and consistently oriented; shells may overlap, nest,
///   cross.
/// - `kSheet`: any mesh; it comes apart where neighbours are turned against each other.
/// - `thicken` above 0: any mesh with an area; the grid's input report is then that of the shell.
///
/// The time grows with the triangles times the depth. Throws `kInvalidMesh` if an index is out of
/// range or a coordinate not finite, `kInvalidOption` (see `check_options`), `kNotClosed` if the
/// mesh is not what the inside rule demands or encloses nothing, `kAborted` and `kOutOfMemory`.
Grid build_grid(const Mesh& mesh, const BuildOptions& options = {}, const Progress& progress = {});

}  // namespace kdm
