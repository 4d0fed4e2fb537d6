// SPDX-License-Identifier: MIT
// Tells exactly whether two mesh triangles touch where they should not, from signs of volumes of
// tetrahedra and of areas of triangles.
//
// Two triangles meet iff an edge of one meets the other. If they share one vertex, only the edges
// opposite to it have to be tested; if they share an edge, only whether one triangle is folded onto
// the other. A kernel supplies `Point`, `volume_sign(a, b, c, d)`, `area_sign(a, b, c, axis)`, and
// two quick tests of neighbours that may answer no where the exact answer is yes. The perturbation
// of predicates.h moves both triangles alike, so it plays no part here.
#pragma once

#include "geometry/exact_sign.h"
#include "geometry/lattice.h"
#include "geometry/predicates.h"

namespace kdm {

/// Computes the signs for lattice points, in 64-bit integers.
struct LatticeKernel {
  using Point = LatticePoint;
  static int volume_sign(const Point& a, const Point& b, const Point& c, const Point& d) {
    const auto normal = area_vector({a, b, c});
    std::int64_t volume = 0;
    for (int i = 0; i < 3; ++i) volume += normal[i] * (d[i] - a[i]);
    return volume > 0 ? 1 : (volume < 0 ? -1 : 0);
  }
  static int area_sign(const Point& a, const Point& b, const Point& c, int axis) {
    const std::int64_t area = area_vector({a, b, c})[axis];
    return area > 0 ? 1 : (area < 0 ? -1 : 0);
  }
  static bool surely_unfolded(const Point&, const Point&, const Point&, const Point&) {
    return false;
  }
  static bool surely_apart(const Point&, const Point&, const Point&, const Point&, const Point&) {
    return false;
  }
};

/// Computes the signs for points in floating point (see exact_sign.h).
struct RealKernel {
  using Point = Vec3;
  static int volume_sign(const Point& a, const Point& b, const Point& c, const Point& d) {
    return kdm::volume_sign(a, b, c, d);
  }
  static int area_sign(const Point& a, const Point& b, const Point& c, int axis) {
    return kdm::area_sign(a, b, c, axis);
  }

  // Tells whether the triangles (p, q, a) and (p, q, b) surely lead away from their common edge to
  // different sides.
  static bool surely_unfolded(const Point& p, const Point& q, const Point& a, const Point& b) {
    const Vec3 edge = q - p;
    const Vec3 u = a - p;
    const Vec3 v = b - p;
    const double length = edge.squaredNorm();
    const double across = u.dot(v) * length - u.dot(edge) * v.dot(edge);
    return across < -kSure * length * (u.squaredNorm() + v.squaredNorm());
  }

  // Tells whether the triangles (p, a, b) and (p, c, d) surely lie on two sides of a plane through
  // p.
  static bool surely_apart(const Point& p, const Point& a, const Point& b, const Point& c,
                           const Point& d) {
    const std::array<Vec3, 2> first = {a - p, b - p};
    const std::array<Vec3, 2> second = {c - p, d - p};
    const Vec3 normal = direction(first) - direction(second);
    const double size = normal.norm();
    for (const Vec3& u : first) {
      if (!(normal.dot(u) > kSure * size * u.norm())) return false;
    }
    for (const Vec3& u : second) {
      if (!(normal.dot(u) < -kSure * size * u.norm())) return false;
    }
    return true;
  }

 private:
  // Rounding errors of a few products and differences are far below this part of the lengths.
  static constexpr double kSure = 1e-9;

  // Returns the unit vector amid the directions of two vectors.
  static Vec3 direction(const std::array<Vec3, 2>& vectors) {
    const Vec3 sum = vectors[0] / vectors[0].norm() + vectors[1] / vectors[1].norm();
    return sum / sum.norm();
  }
};

/// Tests pairs of triangles for crossings.
template <typename Kernel>
class TriangleCrossing {
 public:
  using Point = typename Kernel::Point;
  using Corners = std::array<Point, 3>;

  /// Tells whether the two triangles, given with the numbers of their corners, have more in common
  /// than the vertices and the edge that they share by number. Touching counts. Triangles without
  /// area meet nothing.
  static bool test(const Corners& a, const Triangle& a_numbers, const Corners& b,
                   const Triangle& b_numbers) {
    std::array<int, 3> in_a{};
    std::array<int, 3> in_b{};
    int shared = 0;
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {
        if (a_numbers[i] != b_numbers[j]) continue;
        in_a[shared] = i;
        in_b[shared] = j;
        ++shared;
        break;
      }
    }
    if (shared == 3) return has_area(a) && has_area(b);
    if (shared == 2 && in_b[0] == in_b[1]) return false;  // a has one vertex twice
    if (shared == 2 && Kernel::surely_unfolded(a[in_a[0]], a[in_a[1]], a[3 - in_a[0] - in_a[1]],
                                               b[3 - in_b[0] - in_b[1]])) {
      return false;
    }
    if (shared == 1 && Kernel::surely_apart(a[in_a[0]], a[(in_a[0] + 1) % 3], a[(in_a[0] + 2) % 3],
                                            b[(in_b[0] + 1) % 3], b[(in_b[0] + 2) % 3])) {
      return false;
    }
    if (apart(a, b, shared, in_b) || apart(b, a, shared, in_a)) return false;
    if (!has_area(a) || !has_area(b)) return false;
    if (shared == 2) return folded(a, b, in_a, in_b);
    for (int i = 0; i < 3; ++i) {
      if ((shared == 0 || i == in_a[0]) && edge_meets(a, i, b)) return true;
      if ((shared == 0 || i == in_b[0]) && edge_meets(b, i, a)) return true;
    }
    return false;
  }

 private:
  static bool has_area(const Corners& t) { return projection(t) >= 0; }

  // Returns an axis along which the triangle is not seen as a line, or -1.
  static int projection(const Corners& t) {
    for (int axis = 0; axis < 3; ++axis) {
      if (Kernel::area_sign(t[0], t[1], t[2], axis) != 0) return axis;
    }
    return -1;
  }

  // Tells whether all corners of `other` that are not shared are strictly on one side of t's plane.
  static bool apart(const Corners& t, const Corners& other, int shared,
                    const std::array<int, 3>& shared_corners) {
    int seen = 0;
    for (int i = 0; i < 3; ++i) {
      if ((shared > 0 && shared_corners[0] == i) || (shared > 1 && shared_corners[1] == i))
        continue;
      const int side = Kernel::volume_sign(t[0], t[1], t[2], other[i]);
      if (side == 0 || side == -seen) return false;
      seen = side;
    }
    return true;
  }

  static bool folded(const Corners& a, const Corners& b, const std::array<int, 3>& in_a,
                     const std::array<int, 3>& in_b) {
    const Point& apex_a = a[3 - in_a[0] - in_a[1]];
    const Point& apex_b = b[3 - in_b[0] - in_b[1]];
    if (Kernel::volume_sign(a[0], a[1], a[2], apex_b) != 0) return false;
    const int axis = projection(a);
    return Kernel::area_sign(a[in_a[0]], a[in_a[1]], apex_a, axis) ==
           Kernel::area_sign(a[in_a[0]], a[in_a[1]], apex_b, axis);
  }

  // Tells whether the edge of s opposite to the corner meets the triangle t.
  static bool edge_meets(const Corners& s, int corner, const Corners& t) {
    const Point& p = s[(corner + 1) % 3];
    const Point& q = s[(corner + 2) % 3];
    const int from = Kernel::volume_sign(t[0], t[1], t[2], p);
    const int to = Kernel::volume_sign(t[0], t[1], t[2], q);
    if (from * to > 0) return false;
    if (from == 0 && to == 0) return coplanar_edge_meets(p, q, t);
    bool left = false;
    bool right = false;
    for (int i = 0; i < 3; ++i) {
      const int side = Kernel::volume_sign(p, q, t[i], t[i == 2 ? 0 : i + 1]);
      left = left || side > 0;
      right = right || side < 0;
    }
    return !(left && right);
  }

  static bool coplanar_edge_meets(const Point& p, const Point& q, const Corners& t) {
    const int axis = projection(t);
    if (contains(t, p, axis) || contains(t, q, axis)) return true;
    for (int i = 0; i < 3; ++i) {
      if (segments_meet(p, q, t[i], t[i == 2 ? 0 : i + 1], axis)) return true;
    }
    return false;
  }

  static bool contains(const Corners& t, const Point& p, int axis) {
    bool left = false;
    bool right = false;
    for (int i = 0; i < 3; ++i) {
      const int side = Kernel::area_sign(t[i], t[i == 2 ? 0 : i + 1], p, axis);
      left = left || side > 0;
      right = right || side < 0;
    }
    return !(left && right);
  }

  static bool segments_meet(const Point& p, const Point& q, const Point& a, const Point& b,
                            int axis) {
    const int pa = Kernel::area_sign(p, q, a, axis);
    const int pb = Kernel::area_sign(p, q, b, axis);
    const int ap = Kernel::area_sign(a, b, p, axis);
    const int aq = Kernel::area_sign(a, b, q, axis);
    if (pa * pb < 0 && ap * aq < 0) return true;
    return (pa == 0 && between(p, q, a)) || (pb == 0 && between(p, q, b)) ||
           (ap == 0 && between(a, b, p)) || (aq == 0 && between(a, b, q));
  }

  // Tells whether p, which must be on the line through a and b, is between them.
  static bool between(const Point& a, const Point& b, const Point& p) {
    for (int i = 0; i < 3; ++i) {
      if (p[i] < std::min(a[i], b[i]) || p[i] > std::max(a[i], b[i])) return false;
    }
    return true;
  }
};

}  // namespace kdm
