// SPDX-License-Identifier: MIT
// Where vertices go (paper 2.2.1).
#pragma once

#include <span>

#include "extract/dual_mesh.h"

namespace kdm {

/// The surface point of every hit, in lattice coordinates.
std::vector<Vec3> hit_points(const GridData& grid, const std::vector<LatticeBox>& boxes);

/// The point of the box with the least squared distances to the hits' planes.
Vec3 vertex_position(const GridData& grid, const std::vector<Vec3>& points,
                     std::span<const Index> hits, const LatticeBox& box);

/// Puts each loop's vertex at the minimum of the squared distances to its hits' planes, within
/// its leaf.
void place_vertices(const GridData& grid, const std::vector<LatticeBox>& boxes,
                    const std::vector<Vec3>& points, DualMesh& mesh);

}  // namespace kdm
