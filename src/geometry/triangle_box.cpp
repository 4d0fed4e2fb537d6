// SPDX-License-Identifier: MIT
// Looks for planes that separate mesh elements from boxes, and clips triangles.
#include "geometry/triangle_box.h"

#include <algorithm>

namespace kdm {
namespace {

// Seen along `axis`, returns on which side of the edge from a to b that corner of the box lies
// which is furthest to the given side (1: left, -1: right). Returns 0 only if the edge is seen as a
// point.
int side_of_furthest_corner(const LatticePoint& a, const LatticePoint& b, int axis,
                            const LatticeBox& box, int side) {
  const int u = next_axis(axis);
  const int v = previous_axis(axis);
  const std::int32_t du = (b[u] - a[u]) * side;
  const std::int32_t dv = (b[v] - a[v]) * side;
  // The area grows with pv where du > 0 and with pu where dv < 0.
  return side_of_edge(a, b, axis, dv < 0 ? box.hi[u] : box.lo[u], du > 0 ? box.hi[v] : box.lo[v]);
}

// Tells whether mesh vertices from `low` to `high` are all below or all above the box, on one axis.
bool separated_by_interval(std::int32_t low, std::int32_t high, std::int32_t box_low,
                           std::int32_t box_high) {
  return below_plane(high, box_low) || !below_plane(low, box_high);
}

// Returns on which side of the triangle's plane a grid vertex is; 1: where the normal points to.
int side_of_plane(const LatticeTriangle& t, const std::array<std::int64_t, 3>& normal,
                  const LatticePoint& p) {
  std::int64_t value = 0;
  for (int i = 0; i < 3; ++i) value += normal[i] * (p[i] - t[0][i]);
  for (int i = 0; i < 3 && value == 0; ++i) value = normal[i];
  return value > 0 ? 1 : (value < 0 ? -1 : 0);
}

}  // namespace

bool vertex_in_box(const LatticePoint& p, const LatticeBox& box) {
  for (int i = 0; i < 3; ++i) {
    if (below_plane(p[i], box.lo[i]) || !below_plane(p[i], box.hi[i])) return false;
  }
  return true;
}

bool edge_meets_box(const LatticePoint& a, const LatticePoint& b, const LatticeBox& box) {
  if (vertex_in_box(a, box) || vertex_in_box(b, box)) return true;
  for (int i = 0; i < 3; ++i) {
    const auto [low, high] = std::minmax(a[i], b[i]);
    if (separated_by_interval(low, high, box.lo[i], box.hi[i])) return false;
  }
  for (int axis = 0; axis < 3; ++axis) {
    if (side_of_furthest_corner(a, b, axis, box, 1) < 0) return false;
    if (side_of_furthest_corner(a, b, axis, box, -1) > 0) return false;
  }
  return true;
}

bool triangle_meets_box(const LatticeTriangle& t, const LatticeBox& box) {
  for (const LatticePoint& p : t) {
    if (vertex_in_box(p, box)) return true;
  }
  for (int i = 0; i < 3; ++i) {
    const auto [low, high] = std::minmax({t[0][i], t[1][i], t[2][i]});
    if (separated_by_interval(low, high, box.lo[i], box.hi[i])) return false;
  }
  const auto normal = area_vector(t);
  LatticePoint front{};
  LatticePoint back{};
  for (int i = 0; i < 3; ++i) {
    front[i] = normal[i] > 0 ? box.hi[i] : box.lo[i];
    back[i] = normal[i] > 0 ? box.lo[i] : box.hi[i];
  }
  if (side_of_plane(t, normal, front) < 0 || side_of_plane(t, normal, back) > 0) return false;
  for (int axis = 0; axis < 3; ++axis) {
    const int side = normal[axis] > 0 ? 1 : (normal[axis] < 0 ? -1 : 0);
    for (int i = 0; i < 3; ++i) {
      const LatticePoint& a = t[i];
      const LatticePoint& b = t[i == 2 ? 0 : i + 1];
      // Seen against its normal the triangle lies to the left of its edges, seen edge-on it lies on
      // them.
      if (side >= 0 && side_of_furthest_corner(a, b, axis, box, 1) < 0) return false;
      if (side <= 0 && side_of_furthest_corner(a, b, axis, box, -1) > 0) return false;
    }
  }
  return true;
}

ClippedPolygon clip_to_box(const LatticeTriangle& t, const LatticeBox& box) {
  ClippedPolygon polygon;
  for (const LatticePoint& p : t) polygon.corners[polygon.size++] = to_vec3(p);
  for (int axis = 0; axis < 3 && polygon.size > 0; ++axis) {
    for (const bool high : {false, true}) {
      const double bound = high ? box.hi[axis] : box.lo[axis];
      const double sign = high ? -1 : 1;
      const auto begin = polygon.corners.begin();
      if (std::all_of(begin, begin + polygon.size,
                      [&](const Vec3& p) { return sign * (p[axis] - bound) >= 0; })) {
        continue;
      }
      ClippedPolygon rest;
      for (int i = 0; i < polygon.size; ++i) {
        const Vec3& a = polygon.corners[i];
        const Vec3& b = polygon.corners[i + 1 == polygon.size ? 0 : i + 1];
        const double from = sign * (a[axis] - bound);
        const double to = sign * (b[axis] - bound);
        if (from >= 0) rest.corners[rest.size++] = a;
        if ((from < 0 && to > 0) || (from > 0 && to < 0)) {
          rest.corners[rest.size++] = a + (b - a) * (from / (from - to));
        }
      }
      polygon = rest;
    }
  }
  return polygon;
}

}  // namespace kdm
