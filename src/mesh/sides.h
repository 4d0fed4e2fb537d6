// SPDX-License-Identifier: MIT
// How the sides of a mesh's triangles are numbered.
//
// Side 3t + i of triangle t leads from its corner i to the next one. The number stands for the
// corner i as well, from which the side starts. Two triangles that share an edge have a side each
// along it; on a consistently oriented surface the two run against each other, and each is the
// other's `opposite`. The half-edges of grids and dual meshes (`HalfEdgeId`) are numbered in the
// same way and have opposites too, but they are no sides of input triangles.
#pragma once

#include "mesh/numbers.h"

namespace kdm {

/// Returns the triangle that a side belongs to.
constexpr TriangleId triangle_of(SideId side) { return side / 3; }

/// Returns which corner (0 to 2) of its triangle a side starts from.
constexpr int corner_of(SideId side) { return static_cast<int>(side % 3); }

/// Returns the corner (0 to 2) that follows a corner in its triangle.
constexpr int next_corner(int corner) { return corner == 2 ? 0 : corner + 1; }

/// Returns the side of the same triangle that starts where the given one ends.
constexpr SideId next_side(SideId side) { return side % 3 == 2 ? side - 2 : side + 1; }

/// Returns the side of the same triangle that ends where the given one starts.
constexpr SideId previous_side(SideId side) { return side % 3 == 0 ? side + 2 : side - 1; }

}  // namespace kdm
