// SPDX-License-Identifier: MIT
// The whole way of a mesh in one call: its grid is built, the surface extracted and reduced to few
// triangles. The command lines and JavaScript's `makeManifold` do just this.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "kdmanifold/build.h"
#include "kdmanifold/extract.h"
#include "kdmanifold/reduce.h"
#include "kdmanifold/simplify.h"

namespace kdm {

/// Whether a result is reduced, and how far. `options.h` describes the same members for programs.
struct ReductionOptions {
  /// Builds at 0.8 times the tolerance, extracts an embedded surface and collapses edges of it, as
  /// long as the result stays within the tolerance of the input (see `reduce`). False: the result
  /// is the grid's own surface, built at the full tolerance. Not set: true unless `quads`, `strict`
  /// off, a strategy without tolerance or a tolerance of 0 speaks against it. True beside one of
  /// these is an error.
  std::optional<bool> reduce = {};
  /// How many triangles are to be left; several numbers, each smaller than the one before, make
  /// several levels of detail. The tolerance counts too. Empty: as few as the tolerance allows.
  std::vector<Index> target_triangles = {};
  /// Removes splits of the grid before the surface is extracted, as long as the grid's surface
  /// stays within this distance of what it was, in model units (see `simplify`): the grid takes
  /// less memory and fewer bytes. The distance comes on top of the tolerance. 0: the grid stays as
  /// it is.
  double simplify = 0;
  /// Only with `simplify`: `removed_material` and `added_material` of `SimplifyOptions`.
  double remove_material = 0;
  double add_material = 0;
  /// Groups of the input's faces that are to stay apart when the result is reduced, such as those
  /// of materials (see `ReduceOptions::keep_groups`): one for each number that `source_faces` of
  /// the result may have. Lines between them stay within the tolerance of where the grid's own
  /// surface has them, whose triangles are each of one group. Empty: groups do not count.
  std::vector<Index> keep_groups = {};
};

/// What `make_manifold` can be told.
struct MakeOptions {
  BuildOptions build = {};
  ExtractOptions extract = {};
  ReductionOptions reduction = {};
};

/// The steps in their order. Those are left out that nobody asked for.
enum class MakeStep { kBuild, kSimplify, kExtract, kReduce };

/// Called when a step begins; returns the progress function of that step, which may be empty.
using StepProgress = std::function<Progress(MakeStep)>;

/// A result with the account of how it was made. If several numbers of triangles were asked for it
/// is the last level. `report` is that of the extraction, as far as reduction leaves it alone.
struct MadeMesh : ExtractedMesh {
  std::optional<SimplifyReport> simplified;  ///< how the grid was simplified; empty: it was not
  std::optional<ReduceReport> reduced;       ///< how it was reduced; empty: it was not
  /// One for each of `target_triangles`, each with its distance from what it was held against.
  std::vector<ReducedLevel> levels;
  /// Of the grid; but the tolerances are those asked for and kept by the whole, as far as there is
  /// one: the grid of a result that is reduced has 0.8 times it.
  GridStats stats;
};

/// The same with the grid that it was made from.
struct MadeManifold : MadeMesh {
  Grid grid;
};

/// Makes a closed, oriented 2-manifold mesh of a mesh: `build_grid`, `extract`, `reduce`, on demand
/// with `simplify` after the first.
///
/// The tolerance holds for the whole, but for what `simplify` is allowed. What is reduced is held
/// against the input, its closed holes against themselves; with `thicken`, whose surface lies off
/// the input, and with `simplify`, against the grid's own surface. Whatever `strict` says, a
/// reduced result is embedded.
///
/// Throws what the steps throw, `kEmptyResult`, and `kInvalidOption` for options that exclude each
/// other; names of options in the message stand in backticks.
MadeManifold make_manifold(const Mesh& mesh, const MakeOptions& options = {},
                           const Progress& progress = {});
/// The same; every step has a progress function of its own.
MadeManifold make_manifold_in_steps(const Mesh& mesh, const MakeOptions& options,
                                    const StepProgress& progress);

/// Says whether `make_manifold` would reduce its result. Throws `kInvalidOption` as it does.
bool reduces(const MakeOptions& options);

/// Makes the result of a grid that was built before, e.g. loaded. Simplifies the grid first if this
/// is asked for. If it was built for a reduced result, or if it is asked for, the result is reduced
/// within what the grid left of its tolerance of the grid's own surface: so it keeps the tolerance
/// that was asked for when it was built.
MadeMesh make_from_grid(Grid& grid, const ExtractOptions& extract,
                        const ReductionOptions& reduction, const StepProgress& progress = {});

/// Extracts an embedded surface and reduces it, held against itself. Not with `quads` and `strict`
/// off.
MadeMesh extract_reduced(const Grid& grid, const ExtractOptions& extract,
                         const ReduceOptions& options, const StepProgress& progress = {});

/// A reduced mesh that needed no grid, or one that did.
struct SimplifiedMesh {
  Mesh mesh;
  /// One for each of `target_triangles`, each with its distance from the mesh; from what was made
  /// of it, if it was rebuilt without `error`.
  std::vector<ReducedLevel> levels;
  ReduceReport report;
  /// What one should know of the repair that the mesh needed first. Empty if it needed none.
  std::vector<Warning> warnings;
  bool rebuilt = false;  ///< it needed some: it was not closed, not 2-manifold or met itself
};

/// Reduces a mesh in whatever state. Vertices of equal position are joined first, once coordinates
/// are rounded to 32 bits. If the mesh is then closed, 2-manifold and embedded, `reduce` does the
/// rest; else `make_manifold` makes it so, with `error` as its tolerance (0: with the default one,
/// and without limit afterwards). Throws what these throw.
SimplifiedMesh simplify_mesh(const Mesh& mesh, const ReduceOptions& options,
                             const StepProgress& progress = {});

}  // namespace kdm
