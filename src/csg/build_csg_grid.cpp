// SPDX-License-Identifier: MIT
// Builds the grid of an expression once.
#include "csg/solids_builder.h"

namespace kdm {

Grid build_csg_grid(const std::vector<Operand>& operands, const Expression& expression,
                    const BuildOptions& options, const Progress& progress) {
  SolidsBuilder builder(operands, expression, options, SolidsBuilder::Builds::kOnce);
  return builder.build(1, SolidsBuilder::Faces::kLeftOut, progress).grid;
}

}  // namespace kdm
