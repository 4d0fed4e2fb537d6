// SPDX-License-Identifier: MIT
// Builds grids of several solids, again and again while some of them are moved.
#pragma once

#include <optional>
#include <vector>

#include "construct/former_cells.h"
#include "inside/solid_states.h"
#include "kdmanifold/boolean.h"
#include "mesh/marks.h"
#include "prepare/joined_solids.h"

namespace kdm {

/// The grid of an expression, and what it was built from.
struct SolidsGrid {
  Grid grid;
  /// If wanted, the faces of all solids that the expression names, in model units, rounded to the
  /// lattice: also those that bound nothing. They do not depend on the order in which the solids
  /// were given.
  Mesh faces;
};

/// Builds the grid of an expression. Whether something was built before makes no difference to the
/// grid, but to the time: operands that have not moved are prepared once, and cells where nothing
/// has changed are taken over, as long as the lattice stays the same.
class SolidsBuilder {
 public:
  enum class Builds { kOnce, kAgain };  ///< whether anything is kept for another grid
  enum class Faces { kLeftOut, kToo };  ///< whether `SolidsGrid::faces` is filled

  /// Throws what `build_csg_grid` throws for options and expressions.
  SolidsBuilder(std::vector<Operand> operands, Expression expression, const BuildOptions& options,
                Builds builds);

  std::size_t operands() const { return operands_.size(); }
  /// Moves an operand to another place.
  void place(Index operand, const Transform& transform);
  /// Does what `build_csg_grid` does, with cells that meet the surface within `share` (above 0, at
  /// most 1) of the tolerance.
  SolidsGrid build(double share, Faces wanted, const Progress& progress);
  /// Returns how many splits of the last grid were taken over from the one before.
  SplitId splits_taken_over() const { return former_.taken_over; }

 private:
  // What must be the same for cells to be the same.
  struct Frame {
    Lattice lattice;
    double tolerance = 0;  // lattice units
    bool open_sides = false;
    std::vector<Index> solid_of_given;
    std::vector<InsideRule> rules;
    std::vector<Index> solid_of;  // per triangle

    bool operator==(const Frame&) const = default;
  };

  std::vector<SolidFaces> prepare(const Progress& progress);
  bool continues(const Frame& frame) const;

  std::vector<Operand> operands_;
  Expression expression_;
  BuildOptions options_;
  bool again_;
  Marks named_;  // operands that the expression names
  std::vector<std::optional<SolidFaces>> prepared_;
  Marks moved_;  // operands that have moved since `former_` was made
  Frame frame_;  // of `former_`
  FormerCells former_;
  std::optional<SolidStates> states_;
};

}  // namespace kdm
