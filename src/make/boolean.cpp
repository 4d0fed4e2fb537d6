// SPDX-License-Identifier: MIT
// Boolean operations from meshes to a mesh.
#include "kdmanifold/boolean.h"

#include "kdmanifold/options.h"
#include "make/step_shares.h"
#include "mesh/progress.h"

namespace kdm {

BooleanMesh boolean(const Expression& expression, const std::vector<Operand>& operands,
                    const BuildOptions& build, const ExtractOptions& extract,
                    const ReductionOptions& reduction, const Progress& progress) {
  check_options(extract);
  MadeManifold made =
      make_solids_in_steps(expression, operands, {build, extract, reduction}, shares_of(progress));
  report_progress(progress, 1.0, "done");
  return BooleanMesh{std::move(static_cast<MadeMesh&>(made)), made.grid.operands()};
}

}  // namespace kdm
