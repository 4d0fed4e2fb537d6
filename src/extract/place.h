// SPDX-License-Identifier: MIT
// Where vertices go (paper 2.2.1).
#pragma once

#include "extract/dual_mesh.h"

namespace kdm {

/// The surface point of every hit, in lattice coordinates.
std::vector<Vec3> hit_points(const GridData& grid, const std::vector<LatticeBox>& boxes);

/// Puts each loop's vertex at the minimum of the squared distances to its hits' planes, within
/// its leaf.
void place_vertices(const GridData& grid, const std::vector<LatticeBox>& boxes,
                    const std::vector<Vec3>& points, DualMesh& mesh);

}  // namespace kdm
