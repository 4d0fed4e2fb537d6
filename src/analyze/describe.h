// SPDX-License-Identifier: MIT
// The counts of a mesh whose faults are known.
#pragma once

#include <span>

#include "mesh/boundary_loops.h"
#include "mesh/faults.h"

namespace kdm {

/// What `describe(mesh)` gives; `faults` are those of the mesh, as `loops` are.
MeshReport describe(const Mesh& mesh, const MeshFaults& faults,
                    std::span<const BoundaryLoop> loops);

}  // namespace kdm
