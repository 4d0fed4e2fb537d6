// SPDX-License-Identifier: MIT
// src/geometry/predicates.h against the polynomial oracle, on random and adversarial input.
#include "geometry/predicates.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <sstream>

#include "support/big_integer_oracle.h"
#include "support/random_meshes.h"
#include "support/sanitized.h"
#include "support/shapes.h"

namespace kdm {
namespace {

constexpr std::int32_t kLow = kLatticeMargin;
constexpr std::int32_t kHigh = kLatticeSize - kLatticeMargin;

class Generator {
 public:
  explicit Generator(std::uint32_t seed) : engine_(seed) {}

  std::int32_t between(std::int32_t low, std::int32_t high) {
    return low + static_cast<std::int32_t>(engine_() % static_cast<std::uint32_t>(high - low + 1));
  }
  LatticePoint point(std::int32_t low, std::int32_t high) {
    const std::int32_t x = between(low, high);
    const std::int32_t y = between(low, high);
    return {x, y, between(low, high)};
  }
  // Ends of the lattice, its middle, and their neighbours.
  LatticePoint extreme_point() {
    LatticePoint p;
    for (std::int32_t& x : p) {
      constexpr std::array<std::int32_t, 6> kValues = {
          kLow, kLow + 1, kLatticeSize / 2 - 1, kLatticeSize / 2, kHigh - 1, kHigh};
      x = kValues[engine_() % kValues.size()];
    }
    return p;
  }

 private:
  std::mt19937 engine_;
};

std::string describe_case(const LatticeTriangle& t, int axis, std::int32_t u, std::int32_t v) {
  std::ostringstream text;
  for (const LatticePoint& p : t) text << '(' << p[0] << ' ' << p[1] << ' ' << p[2] << ") ";
  text << "axis " << axis << " line (" << u << ' ' << v << ')';
  return text.str();
}

// Compares all answers about one line and one triangle; returns whether it is hit.
bool check(const LatticeTriangle& t, int axis, std::int32_t u, std::int32_t v) {
  const oracle::GridLine line(axis, u, v);
  const int expected = oracle::line_crosses(t, line);
  EXPECT_EQ(line_crosses(t, axis, u, v), expected) << describe_case(t, axis, u, v);
  if (expected == 0 || ::testing::Test::HasFailure()) return false;
  const LinePosition position = crossing_position(t, axis, u, v);
  const std::int32_t floor = floor_of(position);
  EXPECT_FALSE(oracle::crossing_below(t, line, expected, floor)) << describe_case(t, axis, u, v);
  EXPECT_TRUE(oracle::crossing_below(t, line, expected, floor + 1)) << describe_case(t, axis, u, v);
  // The fraction is rounded, but not by much.
  const auto [a, b, c] = area_vector(t);
  const std::array<long double, 3> n = {static_cast<long double>(a), static_cast<long double>(b),
                                        static_cast<long double>(c)};
  const long double exact =
      t[0][axis] - (n[next_axis(axis)] * (u - t[0][next_axis(axis)]) +
                    n[previous_axis(axis)] * (v - t[0][previous_axis(axis)])) /
                       n[axis];
  EXPECT_NEAR(real_position(position), static_cast<double>(exact), 1.01 * kFractionUnit)
      << describe_case(t, axis, u, v);
  return true;
}

// Asks along all three axes, through lines near the triangle.
int check_around(const LatticeTriangle& t, Generator& random) {
  int hits = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const int u = next_axis(axis);
    const int v = previous_axis(axis);
    // A corner's line, the line of two corners' coordinates, an edge's midpoint, a random one.
    const std::int32_t i = random.between(0, 2);
    const std::int32_t j = random.between(0, 2);
    const LatticePoint& p = t[static_cast<std::size_t>(i)];
    const LatticePoint& q = t[static_cast<std::size_t>(j)];
    hits += check(t, axis, p[u], p[v]);
    hits += check(t, axis, p[u], q[v]);
    hits += check(t, axis, (p[u] + q[u]) / 2, (p[v] + q[v]) / 2);
    const auto [low_u, high_u] = std::minmax({t[0][u], t[1][u], t[2][u]});
    const auto [low_v, high_v] = std::minmax({t[0][v], t[1][v], t[2][v]});
    hits += check(t, axis, random.between(low_u, high_u), random.between(low_v, high_v));
  }
  return hits;
}

// Most of the time is the oracle's.
constexpr int kFewer = check::kSanitized ? 10 : 1;

TEST(Predicates, AgreeWithTheOracleOnRandomTriangles) {
  Generator random(1);
  int hits = 0;
  for (int i = 0; i < 25000 / kFewer && !HasFailure(); ++i) {
    const LatticeTriangle t = {random.point(kLow, kHigh), random.point(kLow, kHigh),
                               random.point(kLow, kHigh)};
    hits += check_around(t, random);
  }
  EXPECT_GT(hits, 50000 / kFewer);
}

TEST(Predicates, AgreeWithTheOracleWhereEverythingTies) {
  Generator random(2);
  int hits = 0;
  // Coordinates 0 to 3 (above the margin): nearly every line goes through a vertex or an edge,
  // most triangles are axis-parallel or without area.
  for (int i = 0; i < 25000 / kFewer && !HasFailure(); ++i) {
    const LatticeTriangle t = {random.point(kLow, kLow + 3), random.point(kLow, kLow + 3),
                               random.point(kLow, kLow + 3)};
    hits += check_around(t, random);
  }
  EXPECT_GT(hits, 40000 / kFewer);
}

TEST(Predicates, AgreeWithTheOracleAtTheEndsOfTheLattice) {
  Generator random(3);
  int hits = 0;
  for (int i = 0; i < 15000 / kFewer && !HasFailure(); ++i) {
    const LatticeTriangle t = {random.extreme_point(), random.extreme_point(),
                               random.extreme_point()};
    hits += check_around(t, random);
  }
  EXPECT_GT(hits, 15000 / kFewer);
}

TEST(Predicates, AgreeWithTheOracleOnSlivers) {
  Generator random(4);
  int hits = 0;
  for (int i = 0; i < 10000 / kFewer && !HasFailure(); ++i) {
    // c lies within a lattice unit or two of the line through a and b, so the plane is steep and
    // the area tiny or zero.
    const LatticePoint a = random.point(kLow + 4, kHigh - 4);
    const LatticePoint b = random.point(kLow + 4, kHigh - 4);
    LatticePoint c;
    const std::int64_t part = random.between(0, 64);
    for (std::size_t k = 0; k < 3; ++k) {
      c[k] = static_cast<std::int32_t>(a[k] + (b[k] - a[k]) * part / 64 + random.between(-2, 2));
    }
    hits += check_around({a, b, c}, random);
  }
  EXPECT_GT(hits, 5000 / kFewer);
}

TEST(Predicates, AgreeWithTheOracleOnAxisParallelTriangles) {
  Generator random(5);
  int hits = 0;
  for (int i = 0; i < 10000 / kFewer && !HasFailure(); ++i) {
    LatticeTriangle t = {random.point(kLow, kHigh), random.point(kLow, kHigh),
                         random.point(kLow, kHigh)};
    const auto flat = static_cast<std::size_t>(random.between(0, 2));
    t[1][flat] = t[2][flat] = t[0][flat];
    hits += check_around(t, random);
  }
  EXPECT_GT(hits, 9000 / kFewer);
}

// Every triangle over a 3 x 3 x 3 lattice (27^3 of them), every line along one axis: no tie is
// left out. By symmetry of the code in the axes one axis a triangle suffices, taken in turn.
TEST(Predicates, AgreeWithTheOracleOnEverySmallTriangle) {
  const auto corner = [](int i) {
    return LatticePoint{kLow + i % 3, kLow + i / 3 % 3, kLow + i / 9};
  };
  int hits = 0;
  for (int i = 0; i < 27 * 27 * 27 && !HasFailure(); i += kFewer) {
    const LatticeTriangle t = {corner(i % 27), corner(i / 27 % 27), corner(i / 729)};
    for (int line = 0; line < 9; ++line) {
      hits += check(t, (i + line) % 3, kLow + line % 3, kLow + line / 3);
    }
  }
  EXPECT_GT(hits, 5000 / kFewer);
}

TEST(Predicates, VertexOnAPlaneIsBelowIt) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const std::int32_t s : {kLow, kLatticeSize / 2, kHigh}) {
      for (const std::int32_t c : {s - 1, s, s + 1}) {
        LatticePoint p = {s, s, s};
        p[axis] = c;
        const oracle::Point grid = oracle::grid_point({s, s, s});
        const bool expected = (grid[axis] - oracle::mesh_vertex(p)[axis]).sign() > 0;
        EXPECT_EQ(below_plane(c, s), expected) << c << " and plane " << s;
      }
    }
  }
}

TEST(Predicates, EdgeSignIsAntisymmetric) {
  Generator random(6);
  for (int i = 0; i < 100000; ++i) {
    const LatticePoint a = random.point(kLow, kLow + 5);
    const LatticePoint b = random.point(kLow, kLow + 5);
    const int axis = random.between(0, 2);
    const std::int32_t u = random.between(kLow, kLow + 5);
    const std::int32_t v = random.between(kLow, kLow + 5);
    ASSERT_EQ(side_of_edge(a, b, axis, u, v), -side_of_edge(b, a, axis, u, v));
    const bool projects_to_a_point = a[next_axis(axis)] == b[next_axis(axis)] &&
                                     a[previous_axis(axis)] == b[previous_axis(axis)];
    ASSERT_EQ(side_of_edge(a, b, axis, u, v) == 0, projects_to_a_point);
  }
}

// --- What it is all for: closed meshes have one winding number at a grid vertex -----------------

std::vector<LatticeTriangle> on_lattice(const Mesh& mesh, std::int32_t scale) {
  std::vector<LatticeTriangle> out;
  for (const Triangle& t : mesh.triangles) {
    LatticeTriangle lattice;
    for (std::size_t corner = 0; corner < 3; ++corner) {
      for (int axis = 0; axis < 3; ++axis) {
        lattice[corner][static_cast<std::size_t>(axis)] =
            kLatticeSize / 2 + static_cast<std::int32_t>(mesh.positions[t[corner]][axis] * scale);
      }
    }
    out.push_back(lattice);
  }
  return out;
}

// Along the axis upwards (+1) or downwards (-1): surfaces left count +1, surfaces entered -1.
int winding(const std::vector<LatticeTriangle>& mesh, const LatticePoint& p, int axis,
            int direction) {
  const std::int32_t u = p[static_cast<std::size_t>(next_axis(axis))];
  const std::int32_t v = p[static_cast<std::size_t>(previous_axis(axis))];
  int sum = 0;
  for (const LatticeTriangle& t : mesh) {
    const int sign = line_crosses(t, axis, u, v);
    if (sign == 0) continue;
    const bool below =
        floor_of(crossing_position(t, axis, u, v)) < p[static_cast<std::size_t>(axis)];
    if (below == (direction < 0)) sum += sign * direction;
  }
  return sum;
}

void expect_one_winding(const Mesh& mesh, std::int32_t scale, std::int32_t range, int points) {
  const std::vector<LatticeTriangle> triangles = on_lattice(mesh, scale);
  Generator random(7);
  constexpr std::int32_t kMiddle = kLatticeSize / 2;
  for (int i = 0; i < points; ++i) {
    const LatticePoint p = random.point(kMiddle - 1, kMiddle + range + 1);
    const int first = winding(triangles, p, 0, 1);
    for (int axis = 0; axis < 3; ++axis) {
      ASSERT_EQ(winding(triangles, p, axis, 1), first) << "axis " << axis;
      ASSERT_EQ(winding(triangles, p, axis, -1), first) << "axis " << axis;
    }
  }
}

TEST(Predicates, WindingIsTheSameAlongEveryAxis) {
  for (std::uint32_t seed = 0; seed < 100; ++seed) {
    SCOPED_TRACE(seed);
    expect_one_winding(shapes::integer_tetrahedra(12, 4, seed), 1, 4, 40);
    expect_one_winding(shapes::random_voxels(4, 0.5, seed), 1, 4, 40);
    expect_one_winding(shapes::collapsed_polyhedron(3, seed), 1, 3, 40);
    expect_one_winding(shapes::random_tetrahedra(12, seed), 100000, 100000, 40);
    // A coarse lattice under fine geometry: slivers and triangles without area.
    expect_one_winding(shapes::random_tetrahedra(12, seed), 6, 6, 40);
    if (HasFailure()) return;
  }
  expect_one_winding(shapes::doubled_cube(), 4, 4, 200);
  expect_one_winding(shapes::cube_with_flaps(), 10, 10, 2000);
  expect_one_winding(shapes::nested_spheres(), 3, 3, 300);
}

}  // namespace
}  // namespace kdm
