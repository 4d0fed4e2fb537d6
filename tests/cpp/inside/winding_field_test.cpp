// SPDX-License-Identifier: MIT
// Generalised winding numbers against plain sums, and against exact counts of crossings.
#include "inside/winding_field.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "geometry/predicates.h"
#include "geometry/solid_angle.h"
#include "inside/winding_tree.h"
#include "prepare/surface.h"
#include "support/random.h"
#include "support/shapes.h"

namespace kdm {
namespace {

using check::Random;

// How far apart points are asked for, if all over the lattice.
constexpr double kSpacing = kLatticeSize / 256;

// By the textbook: one arc tangent a triangle.
double plain_winding(const std::vector<LatticeTriangle>& triangles, const Vec3& p) {
  double sum = 0;
  for (const LatticeTriangle& t : triangles) {
    const Vec3 a = to_vec3(t[0]) - p;
    const Vec3 b = to_vec3(t[1]) - p;
    const Vec3 c = to_vec3(t[2]) - p;
    const double denominator = a.norm() * b.norm() * c.norm() + a.dot(b) * c.norm() +
                               b.dot(c) * a.norm() + c.dot(a) * b.norm();
    sum += 2 * std::atan2(a.dot(b.cross(c)), denominator);
  }
  return sum / (4 * std::acos(-1.0));
}

std::vector<LatticeTriangle> on_lattice(const Mesh& mesh) {
  return prepare_surface(mesh, {.inside = InsideRule::kSheet}).triangles;
}

// Exact: crossings of the line that goes up from the grid vertex.
int crossings_above(const std::vector<LatticeTriangle>& triangles, const LatticePoint& p) {
  int winding = 0;
  for (const LatticeTriangle& t : triangles) {
    const int sign = line_crosses(t, 0, p[1], p[2]);
    if (sign != 0 && floor_of(crossing_position(t, 0, p[1], p[2])) >= p[0]) winding += sign;
  }
  return winding;
}

TEST(SolidAngle, ArcTangentIsThatOfTheLibrary) {
  for (double x = 0; x <= 1; x += 1.0 / 1024) {
    EXPECT_NEAR(arc_tangent(x), std::atan(x), 1e-14) << x;
    EXPECT_NEAR(arc_tangent(-x), std::atan(-x), 1e-14) << x;
  }
}

TEST(SolidAngle, AnglesAddUpOverManyTurns) {
  Random random(7);
  for (int trial = 0; trial < 200; ++trial) {
    AngleSum sum;
    double expected = 0;
    for (int i = 0; i < 100; ++i) {
      const double re = random.between(-2, trial % 2 == 0 ? 2 : -1);
      const double im = random.between(trial % 3 == 0 ? 0 : -1, 1);
      sum.add(re, im);
      expected += std::atan2(im, re);
      EXPECT_NEAR(sum.turns(), expected / (2 * std::acos(-1.0)), 1e-12);
    }
  }
}

TEST(SolidAngle, TwoHalfTurnsAreATurn) {
  AngleSum sum;
  sum.add(-1, 0);
  sum.add(-3, 0);
  EXPECT_EQ(sum.turns(), 1);
}

TEST(WindingField, DecidesAsThePlainSumDoes) {
  Random random(3);
  const std::vector<Mesh> meshes = {
      shapes::open(shapes::icosphere(3), 200), shapes::open(shapes::torus(), 300),
      shapes::soup(shapes::jittered(shapes::soup(shapes::icosphere(3)), 0.03, 5)),
      shapes::open(shapes::cube(), 2)};
  for (const Mesh& mesh : meshes) {
    const std::vector<LatticeTriangle> triangles = on_lattice(mesh);
    for (const double threshold : {0.3, 0.5}) {
      const WindingField field(triangles, threshold, kSpacing);
      int inside = 0;
      for (int i = 0; i < 2000; ++i) {
        const Vec3 p = random.point(0.1 * kLatticeSize, 0.9 * kLatticeSize);
        const double expected = plain_winding(triangles, p);
        if (std::abs(expected - threshold) < 0.01) continue;
        EXPECT_EQ(field.inside(p), expected > threshold) << p.transpose();
        inside += expected > threshold ? 1 : 0;
      }
      EXPECT_GT(inside, 200);
    }
  }
}

// Points close together, for which boxes as small as they come are made.
TEST(WindingField, ManyPointsInOneBoxAreEachSummedRight) {
  Random random(4);
  for (const Mesh& mesh :
       {shapes::open(shapes::icosphere(4), 900), shapes::open(shapes::torus(), 300),
        shapes::soup(shapes::jittered(shapes::soup(shapes::icosphere(3)), 0.05, 6))}) {
    const std::vector<LatticeTriangle> triangles = on_lattice(mesh);
    const WindingField field(triangles, 0.5, 64);
    double squares = 0;
    for (int place = 0; place < 40; ++place) {
      const Vec3 middle = random.point(0.05 * kLatticeSize, 0.95 * kLatticeSize);
      for (int i = 0; i < 10; ++i) {
        const Vec3 p = middle + random.point(-200, 200);
        const double expected = plain_winding(triangles, p);
        const double error = field.excess(p) + 0.5 - expected;
        EXPECT_LT(std::abs(error), 0.02);
        squares += error * error;
        EXPECT_NEAR(field.winding(p), expected, 0.025);
      }
    }
    EXPECT_LT(std::sqrt(squares / 400), 0.006);
  }
}

// What was asked before changes nothing.
TEST(WindingField, TheOrderOfPointsDoesNotMatter) {
  const std::vector<LatticeTriangle> triangles =
      on_lattice(shapes::open(shapes::icosphere(3), 200));
  std::vector<Vec3> points;
  Random random(5);
  for (int i = 0; i < 200; ++i) points.push_back(random.point(0, kLatticeSize));
  const WindingField forwards(triangles, 0.5, 1000);
  const WindingField backwards(triangles, 0.5, 1000);
  std::vector<double> values;
  for (const Vec3& p : points) values.push_back(forwards.excess(p));
  for (std::size_t i = points.size(); i-- > 0;) EXPECT_EQ(backwards.excess(points[i]), values[i]);
}

// The part of all triangles that is summed for each of many points close to each other.
TEST(WindingField, PointsCloseTogetherShareWhatIsFar) {
  const std::vector<LatticeTriangle> triangles =
      on_lattice(shapes::open(shapes::icosphere(5), 9000));
  const WindingField field(triangles, 0.5, 64);
  const Vec3 middle = to_vec3(triangles[0][0]) + Vec3(3000, 0, 0);
  Random random(6);
  const std::size_t before = field.work();
  constexpr std::size_t kPoints = 500;
  for (std::size_t i = 0; i < kPoints; ++i) field.excess(middle + random.point(-100, 100));
  EXPECT_LT((field.work() - before) / kPoints, triangles.size() / 100);
}

// Grid vertices on faces, edges and corners are on the side that crossings say.
TEST(WindingField, GridVerticesOfClosedSurfacesAreExact) {
  Random random(11);
  for (const Mesh& mesh : {shapes::cube(), shapes::stairs(4), shapes::nested_spheres(),
                           shapes::icosphere(1), shapes::face_to_face_cubes()}) {
    const std::vector<LatticeTriangle> triangles = on_lattice(mesh);
    const WindingField field(triangles, 0.5, kSpacing);
    const auto compare = [&](const LatticePoint& p) {
      EXPECT_EQ(field.inside(p), crossings_above(triangles, p) > 0)
          << p[0] << ' ' << p[1] << ' ' << p[2];
    };
    for (const LatticeTriangle& t : triangles) {
      for (int k = 0; k < 3; ++k) {
        compare(t[k]);
        LatticePoint middle;
        for (int i = 0; i < 3; ++i) middle[i] = (t[k][i] + t[(k + 1) % 3][i]) / 2;
        compare(middle);
      }
      LatticePoint within;
      for (int i = 0; i < 3; ++i) within[i] = (t[0][i] + t[1][i] + 2 * t[2][i]) / 4;
      compare(within);
    }
    for (int i = 0; i < 300; ++i) {
      LatticePoint p;
      for (int k = 0; k < 3; ++k) p[k] = static_cast<std::int32_t>(random.below(kLatticeSize));
      compare(p);
    }
  }
}

TEST(WindingField, GradientPointsInwardsAtAHole) {
  const std::vector<LatticeTriangle> triangles = on_lattice(shapes::open(shapes::cube(), 2));
  const WindingField field(triangles, 0.5, kSpacing);
  // Whichever face is missing: along the line through its middle the field falls outwards.
  Vec3 missing = Vec3::Zero();
  for (const LatticeTriangle& t : triangles) {
    const auto area = area_vector(t);
    missing -= Vec3(static_cast<double>(area[0]), static_cast<double>(area[1]),
                    static_cast<double>(area[2]));
  }
  missing.normalize();
  const Vec3 middle = Vec3::Constant(kLatticeSize / 2);
  const Vec3 gradient = field.gradient(middle + 0.45 * kLatticeSize * missing);
  EXPECT_LT(gradient.dot(missing), -0.99 * gradient.norm());
}

TEST(WindingThreshold, KeepsWhatItCan) {
  const auto chosen = [](const Mesh& mesh) {
    return WindingField(on_lattice(mesh), 0, kSpacing).threshold();
  };
  // As it is usual wherever that keeps all, or nothing does.
  EXPECT_EQ(chosen(shapes::cube()), 0.5);
  EXPECT_EQ(chosen(shapes::open(shapes::cube(), 2)), 0.5);
  EXPECT_EQ(chosen(shapes::merged({shapes::icosphere(2), shapes::icosphere(2, 0.5)})), 0.5);
  EXPECT_EQ(WindingField({}, 0, kSpacing).threshold(), 0.5);
  // Turned inwards, no side of a wall sees as much as half of its surroundings from behind.
  const Mesh room = shapes::inverted(shapes::open(shapes::cube(), 2));
  EXPECT_LT(chosen(room), 0.2);
  // And what is said counts.
  EXPECT_EQ(WindingField(on_lattice(room), 0.7, kSpacing).threshold(), 0.7);
}

std::array<Vec3, 3> seen_from(const Vec3& p, const LatticeTriangle& t) {
  return {to_vec3(t[0]) - p, to_vec3(t[1]) - p, to_vec3(t[2]) - p};
}

double turns_of(const std::array<Vec3, 3>& corners) {
  const HalfSolidAngle angle(corners[0], corners[1], corners[2]);
  AngleSum sum;
  sum.add(angle.re, angle.im);
  return sum.turns();
}

TEST(WindingField, SolidAnglesChangeAsTheirGradientSays) {
  Random random(8);
  for (int i = 0; i < 200; ++i) {
    const std::array<Vec3, 3> corners{random.point(-1, 1), random.point(-1, 1),
                                      random.point(-1, 1)};
    const auto moved = [&](const Vec3& by) {
      return turns_of({corners[0] - by, corners[1] - by, corners[2] - by});
    };
    const Vec3 gradient = solid_angle_gradient(corners) / (4 * 3.141592653589793);
    for (int k = 0; k < 3; ++k) {
      constexpr double kStep = 1e-5;
      Vec3 by = Vec3::Zero();
      by[k] = kStep;
      const double difference = moved(by) - moved(-by);
      if (std::abs(difference) > 0.5) continue;  // through the triangle
      EXPECT_NEAR(difference / (2 * kStep), gradient[k], 1e-4 * (1 + gradient.squaredNorm()));
    }
  }
}

TEST(WindingField, GradientIsThatOfAllTriangles) {
  const std::vector<LatticeTriangle> triangles =
      on_lattice(shapes::open(shapes::icosphere(4), 2560));
  const WindingField field(triangles, 0.5, kSpacing);
  Random random(9);
  for (int i = 0; i < 100; ++i) {
    const Vec3 p = random.point(0, kLatticeSize);
    Vec3 sum = Vec3::Zero();
    for (const LatticeTriangle& t : triangles) sum += solid_angle_gradient(seen_from(p, t));
    sum /= 4 * 3.141592653589793;
    EXPECT_LT((field.gradient(p) - sum).norm(), 0.01 * sum.norm() + 0.3 / kLatticeSize);
  }
}

// Whatever a standard library does when it parts numbers: sums are the same everywhere.
TEST(WindingTree, KeepsTheOrderOfTriangles) {
  std::mt19937 random(1);
  std::vector<LatticeTriangle> triangles(500);
  for (LatticeTriangle& t : triangles) {
    for (LatticePoint& p : t) {
      for (std::int32_t& c : p) c = static_cast<std::int32_t>(random() % kLatticeSize);
    }
  }
  const WindingTree tree(triangles);
  std::vector<Index> open{0};
  std::size_t seen = 0;
  while (!open.empty()) {
    const Index number = open.back();
    open.pop_back();
    const WindingTree::Node& node = tree.node(number);
    if (node.right != 0) {
      open.push_back(number + 1);
      open.push_back(node.right);
      continue;
    }
    const LatticeTriangle* last = nullptr;
    const std::array<Index, 1> leaf{number};
    tree.visit(
        node.dipole.centre, leaf, [](const auto&, const Vec3&, double) {},
        [](const auto&, const Vec3&, double) {},
        [&](const LatticeTriangle& t) {
          EXPECT_TRUE(last == nullptr || last < &t);
          last = &t;
          ++seen;
        });
  }
  EXPECT_GT(seen, 400u);
}

}  // namespace
}  // namespace kdm
