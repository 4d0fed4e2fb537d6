// SPDX-License-Identifier: MIT
// Crossings of triangles, from signs of tetrahedra's volumes and triangles' areas.
//
// Two triangles meet iff an edge of one meets the other. With one shared vertex, only the edges
// opposite to it have to be asked; with a shared edge, only whether one is folded onto the other.
#include "geometry/triangle_triangle.h"

#include <cstdlib>

#include "geometry/predicates.h"

namespace kdm {
namespace {

constexpr int sign_of(std::int64_t value) { return value > 0 ? 1 : (value < 0 ? -1 : 0); }

int side_of_plane(const LatticeTriangle& t, const std::array<std::int64_t, 3>& normal,
                  const LatticePoint& p) {
  std::int64_t value = 0;
  for (int i = 0; i < 3; ++i) value += normal[i] * (p[i] - t[0][i]);
  return sign_of(value);
}

// Sign of the volume of tetrahedron p, q, a, b.
int turn(const LatticePoint& p, const LatticePoint& q, const LatticePoint& a,
         const LatticePoint& b) {
  return side_of_plane({p, q, a}, area_vector({p, q, a}), b);
}

int longest_axis_of(const std::array<std::int64_t, 3>& v) {
  int axis = 0;
  for (int i = 1; i < 3; ++i) {
    if (std::abs(v[i]) > std::abs(v[axis])) axis = i;
  }
  return axis;
}

// Seen along `axis`.
int side_in_plane(const LatticePoint& a, const LatticePoint& b, const LatticePoint& p, int axis) {
  return sign_of(area_vector({a, b, p})[axis]);
}

bool point_in_coplanar(const LatticePoint& p, const LatticeTriangle& t, int axis) {
  bool left = false;
  bool right = false;
  for (int i = 0; i < 3; ++i) {
    const int side = side_in_plane(t[i], t[i == 2 ? 0 : i + 1], p, axis);
    left = left || side > 0;
    right = right || side < 0;
  }
  return !(left && right);
}

bool within(const LatticePoint& a, const LatticePoint& b, const LatticePoint& p) {
  for (int i = 0; i < 3; ++i) {
    if (p[i] < std::min(a[i], b[i]) || p[i] > std::max(a[i], b[i])) return false;
  }
  return true;
}

bool coplanar_segments_meet(const LatticePoint& p, const LatticePoint& q, const LatticePoint& a,
                            const LatticePoint& b, int axis) {
  const int pa = side_in_plane(p, q, a, axis);
  const int pb = side_in_plane(p, q, b, axis);
  const int ap = side_in_plane(a, b, p, axis);
  const int aq = side_in_plane(a, b, q, axis);
  if (pa * pb < 0 && ap * aq < 0) return true;
  return (pa == 0 && within(p, q, a)) || (pb == 0 && within(p, q, b)) ||
         (ap == 0 && within(a, b, p)) || (aq == 0 && within(a, b, q));
}

bool segment_meets_triangle(const LatticePoint& p, const LatticePoint& q,
                            const LatticeTriangle& t) {
  const auto normal = area_vector(t);
  const int from = side_of_plane(t, normal, p);
  const int to = side_of_plane(t, normal, q);
  if (from * to > 0) return false;
  if (from == 0 && to == 0) {
    const int axis = longest_axis_of(normal);
    if (point_in_coplanar(p, t, axis) || point_in_coplanar(q, t, axis)) return true;
    for (int i = 0; i < 3; ++i) {
      if (coplanar_segments_meet(p, q, t[i], t[i == 2 ? 0 : i + 1], axis)) return true;
    }
    return false;
  }
  bool left = false;
  bool right = false;
  for (int i = 0; i < 3; ++i) {
    const int side = turn(p, q, t[i], t[i == 2 ? 0 : i + 1]);
    left = left || side > 0;
    right = right || side < 0;
  }
  return !(left && right);
}

// Are all corners of `other`, but those that are corners of `t`, strictly on one side of t's plane?
bool apart_from_plane(const NumberedTriangle& t, const NumberedTriangle& other) {
  const auto normal = area_vector(t.at);
  int seen = 0;
  for (int i = 0; i < 3; ++i) {
    if (other.corners[i] == t.corners[0] || other.corners[i] == t.corners[1] ||
        other.corners[i] == t.corners[2]) {
      continue;
    }
    const int side = side_of_plane(t.at, normal, other.at[i]);
    if (side == 0 || side == -seen) return false;
    seen = side;
  }
  return seen != 0;
}

}  // namespace

bool triangles_cross(const NumberedTriangle& a, const NumberedTriangle& b) {
  if (apart_from_plane(a, b) || apart_from_plane(b, a)) return false;
  std::array<int, 3> in_a{};
  std::array<int, 3> in_b{};
  int shared = 0;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      if (a.corners[i] != b.corners[j]) continue;
      in_a[shared] = i;
      in_b[shared] = j;
      ++shared;
      break;
    }
  }
  const auto opposite = [](const LatticeTriangle& t, int corner, const LatticeTriangle& other) {
    return segment_meets_triangle(t[(corner + 1) % 3], t[(corner + 2) % 3], other);
  };
  switch (shared) {
    case 0:
      for (int i = 0; i < 3; ++i) {
        if (opposite(a.at, i, b.at) || opposite(b.at, i, a.at)) return true;
      }
      return false;
    case 1:
      return opposite(a.at, in_a[0], b.at) || opposite(b.at, in_b[0], a.at);
    case 2: {
      const LatticePoint& apex_a = a.at[3 - in_a[0] - in_a[1]];
      const LatticePoint& apex_b = b.at[3 - in_b[0] - in_b[1]];
      const auto normal = area_vector(a.at);
      if (side_of_plane(a.at, normal, apex_b) != 0) return false;
      const int axis = longest_axis_of(normal);
      const LatticePoint& p = a.at[in_a[0]];
      const LatticePoint& q = a.at[in_a[1]];
      return side_in_plane(p, q, apex_a, axis) == side_in_plane(p, q, apex_b, axis);
    }
    default:
      return true;
  }
}

}  // namespace kdm
