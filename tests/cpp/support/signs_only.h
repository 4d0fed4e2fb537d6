// SPDX-License-Identifier: MIT
// The method with which the paper compares itself in figure 11: dual contouring of signs at grid
// vertices.
#pragma once

#include "kdmanifold/mesh.h"

namespace kdm::check {

/// Contours a closed mesh on n^3 cubes that fill `box`. A grid vertex is inside if a ray from it
/// crosses the mesh an odd number of times. An edge between an inner and an outer vertex has one
/// hit: the crossing nearest to its middle. A cube has one vertex, where the sum of the squared
/// distances to the planes of its edges' hits is least; all parts of the surface in the cube share
/// it. Returns triangles.
Mesh signs_only_contour(const Mesh& mesh, const Box& box, int n);

}  // namespace kdm::check
