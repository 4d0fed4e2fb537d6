// SPDX-License-Identifier: MIT
// Looks for planes that separate mesh elements from boxes, and clips triangles.
#include "geometry/triangle_box.h"

#include <algorithm>

namespace kdm {
namespace {

// On which sides of an edge the corners of a box lie, seen along an axis. An edge that is seen as a
// point has them on both.
struct CornerSides {
  bool left;   // one corner at least lies to the left
  bool right;  // one corner at least lies to the right
};

// Looks at the two corners that lie furthest to either side. `side_of_edge` has the formula.
CornerSides sides_of_corners(const LatticePoint& a, const LatticePoint& b, int axis,
                             const LatticeBox& box) {
  const int u = next_axis(axis);
  const int v = previous_axis(axis);
  const std::int64_t du = b[u] - a[u];
  const std::int64_t dv = b[v] - a[v];
  // The area grows with pv where du > 0 and with pu where dv < 0.
  const std::int32_t left_u = dv < 0 ? box.hi[u] : box.lo[u];
  const std::int32_t left_v = du > 0 ? box.hi[v] : box.lo[v];
  const std::int32_t right_u = dv < 0 ? box.lo[u] : box.hi[u];
  const std::int32_t right_v = du > 0 ? box.lo[v] : box.hi[v];
  const std::int64_t left = du * (left_v - a[v]) - dv * (left_u - a[u]);
  const std::int64_t right = du * (right_v - a[v]) - dv * (right_u - a[u]);
  // A corner on the edge's line is moved off it by the perturbation.
  return {left != 0 ? left > 0 : side_of_edge(a, b, axis, left_u, left_v) >= 0,
          right != 0 ? right < 0 : side_of_edge(a, b, axis, right_u, right_v) <= 0};
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

bool long_edge_meets_box(const LatticePoint& a, const LatticePoint& b, const LatticeBox& box) {
  for (int axis = 0; axis < 3; ++axis) {
    const auto [left, right] = sides_of_corners(a, b, axis, box);
    if (!left || !right) return false;
  }
  return true;
}

bool wide_triangle_meets_box(const LatticeTriangle& t, const LatticeBox& box) {
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
      const auto [left, right] = sides_of_corners(a, b, axis, box);
      if ((side >= 0 && !left) || (side <= 0 && !right)) return false;
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
