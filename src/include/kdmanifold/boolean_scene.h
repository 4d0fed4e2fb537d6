// SPDX-License-Identifier: MIT
// Boolean operations whose operands are moved, fast enough to drag them.
#pragma once

#include <memory>

#include "kdmanifold/boolean.h"

namespace kdm {

/// Solids of which some are moved, and what an expression says of them. Every result is the same,
/// to the byte, as that of `boolean` with the operands where they are, however they came there; but
/// it takes less time, since only what has changed is done again:
/// - Operands that were not moved are prepared once: sewn, closed, turned, rebuilt.
/// - Cells in which neither the old nor the new place of a moved operand has anything stay as they
///   are. For this the bounding box of all operands together must stay the same, as it does while a
///   smaller solid is moved within a larger one: the lattice follows from it, and every vertex from
///   the lattice. If the box changes, all cells are made anew.
///
/// Holds about twice the memory of a grid between results.
class BooleanScene {
 public:
  /// Refers to the operands' meshes, which must live as long. Throws `kInvalidOption` as `boolean`
  /// does; what is wrong with the operands turns up with the first result.
  BooleanScene(const Expression& expression, const std::vector<Operand>& operands,
               const MakeOptions& options = {});
  BooleanScene(BooleanScene&&) noexcept;
  BooleanScene& operator=(BooleanScene&&) noexcept;
  ~BooleanScene();

  /// Moves an operand to another place, for the next result. Throws `kInvalidOption` if there is no
  /// such operand. What is wrong with the transform turns up with the result.
  void place(Index operand, const Transform& transform);

  /// Makes the result. Throws what `boolean` throws; the scene stays usable then, also if
  /// `progress` stopped it.
  BooleanMesh make(const Progress& progress = {});
  /// The same with the grid; every step has a progress function of its own.
  MadeManifold make_in_steps(const StepProgress& progress);

  /// Moves an operand and makes the result.
  BooleanMesh update(Index operand, const Transform& transform, const Progress& progress = {});

 private:
  struct Data;
  std::unique_ptr<Data> data_;
};

}  // namespace kdm
