// SPDX-License-Identifier: MIT
// What the paper compares itself with (fig. 11): dual contouring from signs at grid vertices.
#pragma once

#include "kdmanifold/mesh.h"

namespace kdm::check {

/// Dual contouring of a closed mesh on n^3 cubes over `box`: a grid vertex is inside if a ray from
/// it crosses the mesh an odd number of times; an edge between an inner and an outer vertex has one
/// hit, the crossing nearest to its middle; a cube has one vertex, at the least squared distance to
/// the planes of its edges' hits. Triangles; the cube's vertex is shared by all parts that meet it.
Mesh signs_only_contour(const Mesh& mesh, const Box& box, int n);

}  // namespace kdm::check
