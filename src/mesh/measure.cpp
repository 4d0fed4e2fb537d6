// SPDX-License-Identifier: MIT
// Sums triangles up.
#include "mesh/measure.h"

#include <cmath>

#include "geometry/triangle.h"

namespace kdm {

void Measure::add(const Vec3& p, const Vec3& q, const Vec3& r) {
  const Vec3 a = p - centre;
  const Vec3 n = doubled_area_vector(a, q - centre, r - centre);
  area += std::sqrt(n.x() * n.x() + n.y() * n.y() + n.z() * n.z()) / 2;
  const double term = (a.x() * n.x() + a.y() * n.y() + a.z() * n.z()) / 6;
  volume += term;
  absolute_volume += std::abs(term);
}

double area_of(const Mesh& mesh) {
  Measure sum;
  const auto add = [&](Index a, Index b, Index c) {
    sum.add(mesh.positions[a], mesh.positions[b], mesh.positions[c]);
  };
  for (const Triangle& t : mesh.triangles) add(t[0], t[1], t[2]);
  for (const Quad& q : mesh.quads) {
    add(q[0], q[1], q[2]);
    add(q[0], q[2], q[3]);
  }
  return sum.area;
}

}  // namespace kdm
