// SPDX-License-Identifier: MIT
// Source faces and normals of a reduced mesh, taken from the mesh that it was made from.
#pragma once

#include "kdmanifold/mesh.h"
#include "reduce/reference.h"
#include "reduce/scaled_mesh.h"

namespace kdm {

/// The mesh that was reduced.
struct Carrier {
  const ScaledMesh& mesh;
  const std::vector<Index>& groups;  ///< per triangle, or empty
  const Reference& surface;          ///< its triangles
};

/// Gives the triangles of `to` source faces, and their corners normals, as far as `from` has them.
/// A triangle has the source face of the triangle of `from` that is nearest to its middle, of those
/// that face the same way and are of its group. A corner has the normal that `from` has nearest to
/// a point just inside of the triangle, so that corners on the two sides of a crease keep different
/// normals. `groups` are those of the triangles of `to`, which is scaled by 2^exponent to `from`.
void carry_over(const Carrier& from, const std::vector<Index>& groups, int exponent, Mesh& to);

}  // namespace kdm
