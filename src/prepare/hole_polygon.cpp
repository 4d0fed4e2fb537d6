// SPDX-License-Identifier: MIT
// Sums up the area vectors of the triangles that the edges form with the centre.
#include "prepare/hole_polygon.h"

#include <algorithm>
#include <cmath>

#include "geometry/triangle.h"
#include "mesh/boxes.h"
#include "mesh/sides.h"

namespace kdm {

HolePolygon measure_hole(std::span<const SideId> sides, std::span<const Triangle> triangles,
                         const std::vector<Vec3>& points) {
  HolePolygon polygon;
  for (auto side = sides.rbegin(); side != sides.rend(); ++side) {
    const Triangle& t = triangles[triangle_of(*side)];
    polygon.corners.push_back(t[next_corner(corner_of(*side))]);
    polygon.beyond.push_back(doubled_area_vector(points[t[0]], points[t[1]], points[t[2]]));
  }
  for (const PointId p : polygon.corners) {
    polygon.centre += points[p];
    grow(polygon.bounds, points[p]);
  }
  polygon.centre /= static_cast<double>(polygon.corners.size());
  Vec3 sum = Vec3::Zero();
  PointId last = polygon.corners.back();
  for (const PointId p : polygon.corners) {
    sum += doubled_area_vector(polygon.centre, points[last], points[p]);
    last = p;
  }
  polygon.area = sum.norm() / 2;
  polygon.normal = normalized_or_zero(sum);
  for (const PointId p : polygon.corners) {
    const double distance = std::abs(polygon.normal.dot(points[p] - polygon.centre));
    polygon.deviation = std::max(polygon.deviation, distance);
  }
  return polygon;
}

}  // namespace kdm
