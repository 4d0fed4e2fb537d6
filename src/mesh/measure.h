// SPDX-License-Identifier: MIT
// Area and enclosed volume of triangles, summed up in one order of operations everywhere.
#pragma once

#include "kdmanifold/mesh.h"

namespace kdm {

/// Sums up the areas of triangles and the volumes of the tetrahedra that they form with a centre.
/// The volumes of all triangles of a closed surface add up to what it encloses, wherever the centre
/// is; if it is amid the triangles, the terms and with them their rounding errors are small.
struct Measure {
  Vec3 centre = Vec3::Zero();
  double area = 0;
  double volume = 0;           ///< positive where normals point outwards
  double absolute_volume = 0;  ///< sum of the absolute values of the terms of `volume`, whose
                               ///< rounding error is far smaller

  void add(const Vec3& p, const Vec3& q, const Vec3& r);
};

/// Returns the area of the mesh's faces; of a quad that of its two triangles.
double area_of(const Mesh& mesh);

}  // namespace kdm
