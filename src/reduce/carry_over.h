// SPDX-License-Identifier: MIT
// Source faces and normals of a reduced mesh, taken from the mesh that it was made from.
#pragma once

#include "kdmanifold/mesh.h"
#include "reduce/reference.h"
#include "reduce/scaled_mesh.h"

namespace kdm {

/// Gives the triangles of `to` source faces, and their corners normals, as far as `from` has them.
/// A triangle has the source face of the triangle of `from` that is nearest to its middle, of those
/// that face the same way. A corner has the normal that `from` has nearest to a point just inside
/// of the triangle, so that corners on the two sides of a crease keep different normals. `surface`
/// holds the triangles of `from`; `to` is scaled by 2^exponent to them.
void carry_over(const ScaledMesh& from, const Reference& surface, int exponent, Mesh& to);

}  // namespace kdm
