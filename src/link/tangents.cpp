// SPDX-License-Identifier: MIT
// Finds the surface's tangent lines at the hits of a minimal face, and measures how well two hits
// fit.
#include "link/tangents.h"

#include <cmath>

namespace kdm {

void find_tangents(const GridData& grid, const MinimalFace& face,
                   const std::vector<OutlineHit>& outline, std::vector<Tangent>& tangents) {
  tangents.clear();
  const int u = next_axis(face.axis);
  const int v = previous_axis(face.axis);
  for (const OutlineHit& h : outline) {
    const double along = real_position(grid.hits[h.hit].position);
    Tangent t{along, along, 0, 0};
    if (h.side == 0 || h.side == 2) {
      t.v = h.side == 0 ? face.lo(1) : face.hi(1);
    } else {
      t.u = h.side == 3 ? face.lo(0) : face.hi(0);
    }
    const Vec3& normal = grid.plane_of(h.hit).normal;
    const double length = std::sqrt(normal[u] * normal[u] + normal[v] * normal[v]);
    if (length > 0) {
      t.nu = normal[u] / length;
      t.nv = normal[v] / length;
    }
    tangents.push_back(t);
  }
}

double deviation(const Tangent& a, const Tangent& b) {
  const double du = b.u - a.u;
  const double dv = b.v - a.v;
  const double from_a = a.nu * du + a.nv * dv;
  const double from_b = b.nu * du + b.nv * dv;
  constexpr double kByDistance = 1e-6;
  return from_a * from_a + from_b * from_b + kByDistance * (du * du + dv * dv);
}

}  // namespace kdm
