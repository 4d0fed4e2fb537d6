// SPDX-License-Identifier: MIT
// Boolean operations from meshes to a mesh.
#include "kdmanifold/boolean.h"

#include "kdmanifold/options.h"
#include "mesh/progress.h"

namespace kdm {

BooleanMesh boolean(const Expression& expression, const std::vector<Operand>& operands,
                    const BuildOptions& options, const ExtractOptions& extract_options,
                    const Progress& progress) {
  check_options(extract_options);
  const Grid grid =
      build_csg_grid(operands, expression, options, part_of_progress(progress, 0, 0.7));
  return BooleanMesh{extract(grid, extract_options, part_of_progress(progress, 0.7, 1)),
                     grid.operands(), grid.stats()};
}

}  // namespace kdm
