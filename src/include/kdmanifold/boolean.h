// SPDX-License-Identifier: MIT
// Boolean operations on any meshes (paper section 5.2).
#pragma once

#include <optional>
#include <vector>

#include "kdmanifold/expression.h"
#include "kdmanifold/make_manifold.h"

namespace kdm {

/// An affine map of points: a matrix of 3 by 3 and the shift in column 3.
using Transform = Eigen::Matrix<double, 3, 4>;

/// One solid of a Boolean operation. Refers to the mesh, which must live as long.
struct Operand {
  Operand(const Mesh& solid) : mesh(&solid) {}  // NOLINT: lists of meshes are operands
  Operand(const Mesh& solid, const Transform& placed) : mesh(&solid), transform(placed) {}
  Operand(const Mesh& solid, const Transform& placed, InsideRule rule)
      : mesh(&solid), transform(placed), inside(rule) {}

  const Mesh* mesh;
  /// Where the solid goes. May mirror it; must be invertible.
  Transform transform = Transform::Identity();
  /// Which winding numbers are inside this solid; if not set, the options' rule counts. Sheets
  /// have no inside.
  std::optional<InsideRule> inside;
};

/// Builds the grid of what an expression says of some solids. Each of them is prepared by itself as
/// by `build_grid`; the options' relative tolerance is a fraction of the extent of all together.
/// All are rounded to one lattice after they were transformed. Only where the result ends are cells
/// split. Faces on faces, also of different solids and within what rounding moves them, leave
/// nothing behind.
///
/// The grid is that of the solid itself, however it is expressed: the order of the operands of a
/// union plays no role, and solids that are given twice count once. Its `operands` report what the
/// operands are; `input` has the sums.
///
/// Throws what `build_grid` throws; errors of an operand begin with its number. `kInvalidOption` if
/// the expression names an operand that is not there, and for the inside rule `kSheet`;
/// `kInvalidMesh` if a transform is not finite or not invertible.
Grid build_csg_grid(const std::vector<Operand>& operands, const Expression& expression,
                    const BuildOptions& options = {}, const Progress& progress = {});

/// A result with the account of how it was made. `source_operands` says which operand each face is
/// of, and `source_faces` which of that operand's faces.
struct BooleanMesh : MadeMesh {
  std::vector<InputReport> operands;  ///< what was given
};

/// Makes the mesh of what an expression says of some solids, reduced to few triangles as
/// `make_manifold` does it, unless `reduction` or the other options exclude that; held against the
/// faces of all operands, so the tolerance holds for the whole. Throws what `build_csg_grid`,
/// `extract` and `make_manifold` throw.
BooleanMesh boolean(const Expression& expression, const std::vector<Operand>& operands,
                    const BuildOptions& build = {}, const ExtractOptions& extract = {},
                    const ReductionOptions& reduction = {}, const Progress& progress = {});
/// The same with the grid; every step has a progress function of its own.
MadeManifold make_solids_in_steps(const Expression& expression,
                                  const std::vector<Operand>& operands, const MakeOptions& options,
                                  const StepProgress& progress);

}  // namespace kdm
