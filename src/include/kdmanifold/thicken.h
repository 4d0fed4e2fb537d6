// SPDX-License-Identifier: MIT
// Makes shells of some thickness of surfaces that bound nothing.
#pragma once

#include "kdmanifold/mesh.h"

namespace kdm {

/// Makes a closed shell around a surface, half of the thickness to either side: what an open
/// surface needs to be printed or built as a solid. Which way the input is turned does not matter.
///
/// Each piece of the surface gets a copy on either side, its vertices moved along normals weighted
/// by angle (further at creases, so that the sides' planes are `thickness` apart, up to twice as
/// far), and walls along its rim. Pieces end where faces cannot agree on a direction and where the
/// surface turns by more than 95 degrees; of three or more faces at an edge the two that go on
/// straightest stay together. Such ends reach a quarter of the thickness further than rims, so that
/// the shells overlap. Where short edges cannot bear that their ends move in different directions,
/// these are evened out by up to 41 degrees; where even so a copy would turn over, as within a bend
/// that is tighter than half of the thickness, the faces of that side part and overlap.
///
/// The result is closed and consistently oriented, as a set of shells that may overlap and cross:
/// `build_grid` makes their union. Vertices of equal position are joined first; faces with repeated
/// corners and copies of faces are left out. `source_faces` tells the face of `mesh` (or what its
/// `source_faces` says) that each triangle was made from.
///
/// `thickness`: model units, finite and above 0 (else `kInvalidOption`). Throws `kInvalidMesh` if
/// an index is out of range, a coordinate not finite or beyond 1e150, or no face has an area. The
/// time grows linearly with the faces.
Mesh thicken(const Mesh& mesh, double thickness);

}  // namespace kdm
