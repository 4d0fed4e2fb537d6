// SPDX-License-Identifier: MIT
// Describes each part of a mesh.
#pragma once

#include <span>
#include <vector>

#include "kdmanifold/analyze.h"
#include "mesh/boundary_loops.h"
#include "mesh/faults.h"

namespace kdm {

struct PartsReport {
  std::vector<MeshPart> parts;
  bool nesting_known = true;  ///< false if too many closed parts overlap to find which lie in which
};

/// Describes each of `faults.parts`. `faults` and `loops` must be those of the mesh.
PartsReport describe_parts(const Mesh& mesh, const MeshFaults& faults,
                           std::span<const BoundaryLoop> loops);

}  // namespace kdm
