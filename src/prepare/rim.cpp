// SPDX-License-Identifier: MIT
// Computes points and planes at the rim of a surface.
#include "prepare/rim.h"

#include <Eigen/Geometry>
#include <algorithm>

namespace kdm {
namespace {

struct Segment {
  Vec3 from;
  Vec3 along;  // from one end to the other
};

Segment segment_of(const Surface& surface, SideId side) {
  const LatticeTriangle& t = surface.triangles[triangle_of(side)];
  const Vec3 from = to_vec3(t[corner_of(side)]);
  return {from, to_vec3(t[next_corner(corner_of(side))]) - from};
}

}  // namespace

Plane rim_plane(const Surface& surface, SideId side, const Vec3& face_normal) {
  const Segment segment = segment_of(surface, side);
  const Vec3 normal = segment.along.cross(face_normal);
  const double length = normal.norm();
  if (!(length > 0)) return {Vec3::Zero(), 0};
  return {normal / length, normal.dot(segment.from) / length};
}

Vec3 rim_point(const Surface& surface, SideId side, int axis, std::int32_t value) {
  const Segment segment = segment_of(surface, side);
  return segment.from + (value - segment.from[axis]) / segment.along[axis] * segment.along;
}

Vec3 rim_middle(const Surface& surface, SideId side, const LatticeBox& box) {
  const Segment segment = segment_of(surface, side);
  double enters = 0;
  double leaves = 1;
  for (int i = 0; i < 3; ++i) {
    const double along = segment.along[i];
    if (along == 0) continue;
    const double low = (box.lo[i] - segment.from[i]) / along;
    const double high = (box.hi[i] - segment.from[i]) / along;
    enters = std::max(enters, std::min(low, high));
    leaves = std::min(leaves, std::max(low, high));
  }
  const double middle = std::clamp(0.5 * (enters + leaves), 0.0, 1.0);
  return segment.from + middle * segment.along;
}

}  // namespace kdm
