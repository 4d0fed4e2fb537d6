// SPDX-License-Identifier: MIT
// Finds the surface's tangent lines at the hits of a minimal face, and measures how well two hits
// fit.
#pragma once

#include <vector>

#include "link/outline.h"

namespace kdm {

/// The line in which a hit's plane cuts the plane of the face; lattice units.
struct Tangent {
  double u, v;    ///< the hit's point on the face
  double nu, nv;  ///< unit normal of the line; zero if the hit's plane is parallel to the face
};

/// Finds the tangent line of each hit of the outline.
void find_tangents(const GridData& grid, const MinimalFace& face,
                   const std::vector<OutlineHit>& outline, std::vector<Tangent>& tangents);

/// Measures how badly two hits fit each other: the square of the first hit's distance from the
/// second one's tangent line, plus the square of the second hit's distance from the first one's,
/// plus a millionth of the hits' squared distance, which decides between pairs that fit equally
/// well.
double deviation(const Tangent& a, const Tangent& b);

}  // namespace kdm
