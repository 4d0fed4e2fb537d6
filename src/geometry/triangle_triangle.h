// SPDX-License-Identifier: MIT
// Whether two mesh triangles touch where they should not: exact, on lattice coordinates.
//
// Both triangles move alike under the perturbation of predicates.h, so it plays no part here:
// touching counts. Vertices that the two share (by number) may meet, and nothing else.
#pragma once

#include "geometry/lattice.h"
#include "kdmanifold/mesh.h"

namespace kdm {

/// A triangle with area, and the numbers of its corners.
struct NumberedTriangle {
  const LatticeTriangle& at;
  const Triangle& corners;
};

/// Have the two more in common than the vertices and the edge they share?
bool triangles_cross(const NumberedTriangle& a, const NumberedTriangle& b);

}  // namespace kdm
