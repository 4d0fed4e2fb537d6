// SPDX-License-Identifier: MIT
// What there is to be said about each part of a mesh.
#pragma once

#include <span>
#include <vector>

#include "kdmanifold/analyze.h"
#include "mesh/boundary_loops.h"
#include "mesh/faults.h"

namespace kdm {

struct PartsReport {
  std::vector<MeshPart> parts;
  bool nesting_known = true;
};

/// One for each of `faults.parts`, which are those of the mesh, as `loops` are.
PartsReport describe_parts(const Mesh& mesh, const MeshFaults& faults,
                           std::span<const BoundaryLoop> loops);

}  // namespace kdm
