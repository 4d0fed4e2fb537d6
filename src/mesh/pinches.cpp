// SPDX-License-Identifier: MIT
// Walks round the points and compares the lengths of fans with how many triangles there are.
#include "mesh/pinches.h"

#include "mesh/sides.h"

namespace kdm {

Marks find_pinched(std::span<const Triangle> triangles, Index points, const Topology& topology) {
  Marks pinched(triangles.size());
  for (const SideId side : topology.non_manifold_sides) pinched.set(triangle_of(side));
  std::vector<Index> left(points, 0);  // triangles at each point that are in no fan yet
  for (const Triangle& t : triangles) {
    for (const PointId p : t) ++left[p];
  }
  Marks shared(points);
  Marks seen(topology.opposite.size());
  for (SideId side = 0; side < topology.opposite.size(); ++side) {
    if (seen.test(side)) continue;
    const PointId point = triangles[triangle_of(side)][corner_of(side)];
    SideId at = side;
    do {
      seen.set(at);
      --left[point];
      at = topology.opposite[previous_side(at)];
    } while (at != side);
    if (left[point] > 0) shared.set(point);
  }
  for (TriangleId t = 0; t < triangles.size(); ++t) {
    for (const PointId p : triangles[t]) {
      if (shared.test(p)) pinched.set(t);
    }
  }
  return pinched;
}

}  // namespace kdm
