// SPDX-License-Identifier: MIT
// Crossings of triangles against an oracle that solves for common points in rational numbers.
#include "geometry/triangle_triangle.h"

#include <gtest/gtest.h>

#include "geometry/predicates.h"
#include "support/random.h"

namespace kdm {
namespace {

// Exact for the small coordinates used here: a point with a common denominator.
struct Rational {
  std::array<std::int64_t, 3> over{};
  std::int64_t denominator = 1;
};

// Is the point in the closed triangle? Barycentric signs seen along the longest normal axis.
bool in_triangle(const Rational& p, const LatticeTriangle& t) {
  const auto n = area_vector(t);
  std::int64_t height = 0;
  for (int i = 0; i < 3; ++i) height += n[i] * (p.over[i] - t[0][i] * p.denominator);
  if (height != 0) return false;
  for (int i = 0; i < 3; ++i) {
    const LatticePoint& a = t[i];
    const LatticePoint& b = t[(i + 1) % 3];
    // n . ((b - a) x (p - a)) >= 0
    std::array<std::int64_t, 3> e{}, d{};
    for (int k = 0; k < 3; ++k) {
      e[k] = b[k] - a[k];
      d[k] = p.over[k] - a[k] * p.denominator;
    }
    const std::int64_t side = n[0] * (e[1] * d[2] - e[2] * d[1]) +
                              n[1] * (e[2] * d[0] - e[0] * d[2]) +
                              n[2] * (e[0] * d[1] - e[1] * d[0]);
    if (side < 0) return false;
  }
  return true;
}

// All points that decide whether an edge and a triangle meet: corners, and where the edge meets the
// plane of the triangle or, lying in it, an edge of the triangle.
std::vector<Rational> candidates(const LatticePoint& p, const LatticePoint& q,
                                 const LatticeTriangle& t) {
  std::vector<Rational> points;
  const auto add_cut = [&](const std::array<std::int64_t, 3>& n, const LatticePoint& origin) {
    std::int64_t from = 0;
    std::int64_t to = 0;
    for (int i = 0; i < 3; ++i) {
      from += n[i] * (p[i] - origin[i]);
      to += n[i] * (q[i] - origin[i]);
    }
    if ((from > 0 && to > 0) || (from < 0 && to < 0) || from == to) return;
    Rational cut;
    cut.denominator = std::abs(from - to);
    const std::int64_t share = std::abs(from);
    for (int i = 0; i < 3; ++i) cut.over[i] = p[i] * cut.denominator + (q[i] - p[i]) * share;
    points.push_back(cut);
  };
  const auto n = area_vector(t);
  add_cut(n, t[0]);
  for (int i = 0; i < 3; ++i) {
    const LatticePoint& a = t[i];
    const LatticePoint& b = t[(i + 1) % 3];
    std::array<std::int64_t, 3> e{};
    for (int k = 0; k < 3; ++k) e[k] = b[k] - a[k];
    add_cut({n[1] * e[2] - n[2] * e[1], n[2] * e[0] - n[0] * e[2], n[0] * e[1] - n[1] * e[0]}, a);
  }
  for (const LatticePoint& end : {p, q}) points.push_back({{end[0], end[1], end[2]}, 1});
  return points;
}

// Is there a common point other than shared corners and, with two of them, their edge?
bool oracle(const LatticeTriangle& a, const LatticeTriangle& b, const Triangle& na,
            const Triangle& nb) {
  std::vector<LatticePoint> shared;
  for (int i = 0; i < 3; ++i) {
    if (std::find(nb.begin(), nb.end(), na[i]) != nb.end()) shared.push_back(a[i]);
  }
  const auto allowed = [&](const Rational& p) {
    for (const LatticePoint& s : shared) {
      bool same = true;
      for (int i = 0; i < 3; ++i) same = same && p.over[i] == s[i] * p.denominator;
      if (same) return true;
    }
    if (shared.size() < 2) return false;
    // On the line of the shared edge?
    std::array<std::int64_t, 3> e{}, d{};
    for (int i = 0; i < 3; ++i) {
      e[i] = shared[1][i] - shared[0][i];
      d[i] = p.over[i] - shared[0][i] * p.denominator;
    }
    return e[1] * d[2] == e[2] * d[1] && e[2] * d[0] == e[0] * d[2] && e[0] * d[1] == e[1] * d[0];
  };
  for (const auto& [s, t] : {std::pair(a, b), std::pair(b, a)}) {
    for (int i = 0; i < 3; ++i) {
      for (const Rational& p : candidates(s[i], s[(i + 1) % 3], t)) {
        if (in_triangle(p, t) && in_triangle(p, s) && !allowed(p)) return true;
      }
    }
  }
  return false;
}

// By both kernels, which must agree.
bool cross(const LatticeTriangle& a, const Triangle& na, const LatticeTriangle& b,
           const Triangle& nb) {
  const auto real = [](const LatticeTriangle& t) {
    std::array<Vec3, 3> corners;
    for (int i = 0; i < 3; ++i) corners[i] = Vec3(t[i][0], t[i][1], t[i][2]);
    return corners;
  };
  const bool exact = TriangleCrossing<LatticeKernel>::test(a, na, b, nb);
  EXPECT_EQ(TriangleCrossing<RealKernel>::test(real(a), na, real(b), nb), exact);
  return exact;
}

bool has_area(const LatticeTriangle& t) {
  const auto n = area_vector(t);
  return n[0] != 0 || n[1] != 0 || n[2] != 0;
}

// Coordinates from a few values: touching, coplanar and crossing pairs all come often.
TEST(TriangleTriangle, AgreesWithTheOracle) {
  check::Random random(7);
  std::array<int, 8> seen{};
  for (int i = 0; i < 400000; ++i) {
    const int range = i % 3 == 0 ? 3 : (i % 3 == 1 ? 5 : 30);
    const int shared = i % 4;
    const bool flat = i % 5 == 0;
    std::array<LatticePoint, 6> p{};
    for (LatticePoint& q : p) {
      for (int k = 0; k < 3; ++k) q[k] = static_cast<int>(random.below(range));
      if (flat) q[2] = 0;
    }
    const Triangle na{0, 1, 2};
    Triangle nb{3, 4, 5};
    if (shared == 1 || shared == 2) nb[i % 3] = 1;
    if (shared == 2) nb[(i + 1) % 3] = 2;
    const LatticeTriangle a{p[na[0]], p[na[1]], p[na[2]]};
    const LatticeTriangle b{p[nb[0]], p[nb[1]], p[nb[2]]};
    if (!has_area(a) || !has_area(b)) continue;
    // Points are shared by number: equal places under two numbers touch.
    const bool expected = oracle(a, b, na, nb);
    ASSERT_EQ(cross(a, na, b, nb), expected) << "pair " << i;
    ASSERT_EQ(cross(b, nb, a, na), expected) << "pair " << i;
    ++seen[2 * (shared == 3 ? 0 : shared) + (expected ? 1 : 0)];
  }
  for (int i = 0; i < 6; ++i) EXPECT_GT(seen[i], 5000) << i;
}

TEST(TriangleTriangle, TheSameTriangleTwiceCrosses) {
  const LatticeTriangle t{LatticePoint{0, 0, 0}, LatticePoint{4, 0, 0}, LatticePoint{0, 4, 0}};
  const LatticeTriangle back{t[0], t[2], t[1]};
  EXPECT_TRUE(cross(t, {0, 1, 2}, back, {0, 2, 1}));
}

TEST(TriangleTriangle, HoldsAtTheLatticeEnds) {
  constexpr std::int32_t kEnd = kLatticeSize;
  const LatticeTriangle a{LatticePoint{0, 0, 0}, LatticePoint{kEnd, kEnd, 0},
                          LatticePoint{0, kEnd, kEnd}};
  const LatticeTriangle through{LatticePoint{kEnd, 0, 0}, LatticePoint{0, kEnd, 0},
                                LatticePoint{0, kEnd, 1}};
  EXPECT_TRUE(cross(a, {0, 1, 2}, through, {3, 4, 5}));
  const LatticeTriangle beside{LatticePoint{kEnd, 0, 0}, LatticePoint{kEnd, kEnd - 1, 0},
                               LatticePoint{kEnd, 0, kEnd}};
  EXPECT_FALSE(cross(a, {0, 1, 2}, beside, {3, 4, 5}));
}

}  // namespace
}  // namespace kdm
