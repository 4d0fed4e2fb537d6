// SPDX-License-Identifier: MIT
// Describes a mesh whose faults are known already.
#pragma once

#include <span>

#include "mesh/boundary_loops.h"
#include "mesh/faults.h"

namespace kdm {

/// Returns what `describe(mesh)` returns. `faults` and `loops` must be those of the mesh.
MeshReport describe(const Mesh& mesh, const MeshFaults& faults,
                    std::span<const BoundaryLoop> loops);

}  // namespace kdm
