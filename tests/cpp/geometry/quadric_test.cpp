// SPDX-License-Identifier: MIT
// Minimisers against sampling.
#include "geometry/quadric.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "support/random.h"

namespace kdm {
namespace {

using check::Random;

Plane plane_through(const Vec3& point, const Vec3& normal) {
  const Vec3 unit = normal.normalized();
  return {unit, unit.dot(point)};
}

void expect_near(const Vec3& a, const Vec3& b, double tolerance) {
  EXPECT_LE((a - b).cwiseAbs().maxCoeff(), tolerance)
      << "(" << a.transpose() << ") and (" << b.transpose() << ")";
}

TEST(PrimalQuadric, ErrorIsTheSumOfSquaredDistances) {
  Random random(3);
  for (int i = 0; i < 200; ++i) {
    PrimalQuadric quadric(random.point(-10, 10));
    std::vector<Plane> planes;
    for (int k = 0; k < 5; ++k) {
      planes.push_back(plane_through(random.point(-10, 10), random.direction()));
      quadric.add(planes.back());
    }
    const Vec3 x = random.point(-20, 20);
    double sum = 0;
    for (const Plane& p : planes) sum += std::pow(p.normal.dot(x) - p.offset, 2);
    EXPECT_NEAR(quadric.error(x), sum, 1e-9 * (1 + sum));
  }
}

TEST(PrimalQuadric, APlaneTakesTheFootOfThePerpendicular) {
  Random random(4);
  for (int i = 0; i < 200; ++i) {
    const Vec3 centre = random.point(-100, 100);
    const Vec3 on_plane = random.point(-100, 100);
    const Vec3 n = random.direction();
    PrimalQuadric quadric(centre);
    quadric.add(plane_through(on_plane, n));
    quadric.add(plane_through(on_plane, -n));
    expect_near(quadric.minimiser(), centre - n * n.dot(centre - on_plane), 1e-10);
  }
}

TEST(PrimalQuadric, ARidgeTakesItsNearestPoint) {
  Random random(5);
  for (int i = 0; i < 200; ++i) {
    const Vec3 centre = random.point(-100, 100);
    const Vec3 on_ridge = random.point(-100, 100);
    const Vec3 n = random.direction();
    const Vec3 m = n.cross(random.direction()).normalized() + 0.5 * n;
    const Vec3 ridge = n.cross(m).normalized();
    PrimalQuadric quadric(centre);
    quadric.add(plane_through(on_ridge, n));
    quadric.add(plane_through(on_ridge, m));
    expect_near(quadric.minimiser(), on_ridge + ridge * ridge.dot(centre - on_ridge), 1e-8);
  }
}

TEST(PrimalQuadric, ACornerIsMetExactly) {
  Random random(6);
  for (int i = 0; i < 200; ++i) {
    const Vec3 corner = random.point(-100, 100);
    Eigen::Matrix3d normals =
        Eigen::AngleAxisd(random.between(0, 3), random.direction()) * Eigen::Matrix3d::Identity();
    PrimalQuadric quadric(random.point(-100, 100));
    for (int k = 0; k < 3; ++k) quadric.add(plane_through(corner, normals.col(k)));
    expect_near(quadric.minimiser(), corner, 1e-10);
    quadric.add(plane_through(corner, random.direction()));
    expect_near(quadric.minimiser(), corner, 1e-9);
  }
}

TEST(PrimalQuadric, NearlyParallelPlanesCountAsOne) {
  // Two planes through the z axis that differ by `degrees`: a ridge, or one plane seen twice?
  const auto distance_from_ridge = [](double degrees) {
    const double half = degrees / 2 * 3.14159265358979 / 180;
    PrimalQuadric quadric(Vec3(10, 0, 0));
    quadric.add(plane_through(Vec3::Zero(), Vec3(std::sin(half), std::cos(half), 0)));
    quadric.add(plane_through(Vec3::Zero(), Vec3(-std::sin(half), std::cos(half), 0)));
    return quadric.minimiser().norm();
  };
  EXPECT_NEAR(distance_from_ridge(2), 10, 1e-9);
  EXPECT_NEAR(distance_from_ridge(30), 0, 1e-9);
}

TEST(PrimalQuadric, WithoutPlanesTheCentreIsBest) {
  const PrimalQuadric quadric(Vec3(1, 2, 3));
  expect_near(quadric.minimiser(), Vec3(1, 2, 3), 0);
  expect_near(quadric.minimiser_in(Vec3(0, 0, 0), Vec3(5, 5, 5)), Vec3(1, 2, 3), 0);
}

TEST(PrimalQuadric, AMinimiserWithinTheBoxIsTaken) {
  PrimalQuadric quadric(Vec3(1, 1, 1));
  quadric.add(plane_through(Vec3(2, 0, 0), Vec3(1, 0, 0)));
  quadric.add(plane_through(Vec3(0, 3, 0), Vec3(0, 1, 0)));
  expect_near(quadric.minimiser_in(Vec3(0, 0, 0), Vec3(4, 4, 4)), Vec3(2, 3, 1), 1e-12);
}

TEST(PrimalQuadric, AFlatMinimumOnTheBoxStaysNearTheCentre) {
  // Any point of the side x = 1 is equally good.
  PrimalQuadric quadric(Vec3(0.25, 0.5, 0.75));
  quadric.add(plane_through(Vec3(5, 0, 0), Vec3(1, 0, 0)));
  expect_near(quadric.minimiser_in(Vec3(0, 0, 0), Vec3(1, 1, 1)), Vec3(1, 0.5, 0.75), 1e-12);
}

TEST(PrimalQuadric, TheBoxMinimumIsNotAClampedFreeMinimum) {
  // A ridge through (2, 0.5) leaning so that the best point of the side x = 1 is well below 0.5.
  PrimalQuadric quadric(Vec3(0.5, 0.5, 0.5));
  quadric.add(plane_through(Vec3(2, 0.5, 0), Vec3(1, -1.5, 0)));
  quadric.add(plane_through(Vec3(2, 0.5, 0), Vec3(1, -1, 0)));
  const Vec3 x = quadric.minimiser_in(Vec3(0, 0, 0), Vec3(1, 1, 1));
  EXPECT_LT(quadric.error(x), 0.5 * quadric.error(Vec3(1, 0.5, 0.5)));
  EXPECT_NEAR(x[1], 0, 0.01);
}

TEST(PrimalQuadric, NoPointOfTheBoxIsBetter) {
  Random random(7);
  int outside = 0;
  for (int i = 0; i < 3000; ++i) {
    const Vec3 lo = random.point(-5, 0);
    const Vec3 hi = lo + random.point(0.1, 5);
    Vec3 centre;
    for (int k = 0; k < 3; ++k) centre[k] = random.between(lo[k], hi[k]);
    PrimalQuadric quadric(centre);
    const std::uint32_t planes = 1 + random.below(5);
    const Vec3 main = random.direction();
    for (std::uint32_t k = 0; k < planes; ++k) {
      const double spread = random.coin() ? 0.2 : 2;
      quadric.add(plane_through(random.point(-8, 8), main + spread * random.direction()));
    }
    const Vec3 free = quadric.minimiser();
    if ((free.array() < lo.array()).any() || (free.array() > hi.array()).any()) ++outside;
    const Vec3 x = quadric.minimiser_in(lo, hi);
    ASSERT_TRUE((x.array() >= lo.array() - 1e-12).all() && (x.array() <= hi.array() + 1e-12).all())
        << x.transpose();
    if ((x - free).norm() < 1e-12) continue;
    // Off the free minimum: nothing on the box's surface may have less. Ties are broken by a
    // weight of at most 1e-4 of the planes on the distance to the centre.
    constexpr int kSteps = 6;
    for (int axis = 0; axis < 3; ++axis) {
      for (int s = 0; s <= kSteps; ++s) {
        for (int t = 0; t <= kSteps; ++t) {
          for (const bool high : {false, true}) {
            Vec3 f;
            f[axis] = high ? 1 : 0;
            f[(axis + 1) % 3] = static_cast<double>(s) / kSteps;
            f[(axis + 2) % 3] = static_cast<double>(t) / kSteps;
            const Vec3 z = lo + f.cwiseProduct(hi - lo);
            const double slack = 1e-4 * planes * (z - centre).squaredNorm();
            ASSERT_LE(quadric.error(x), quadric.error(z) + slack * (1 + 1e-9) + 1e-9)
                << "quadric " << i << ": (" << x.transpose() << ") and (" << z.transpose() << ")";
          }
        }
      }
    }
  }
  EXPECT_GT(outside, 1000);
}

// A ridge of three degrees: nearly one plane, but its line is where two planes meet.
TEST(PrimalQuadric, ASlightCreaseCountsWhereThePlanesAskForIt) {
  const Vec3 left = Vec3(0.05, 0, 1).normalized();
  const Vec3 right = Vec3(-0.05, 0, 1).normalized();
  PrimalQuadric quadric(Vec3(4, 0, 0));
  quadric.add({left, 0});
  quadric.add({right, 0});
  const Vec3 lo(-10, -10, -10);
  const Vec3 hi(10, 10, 10);
  const auto residual = [&](const Vec3& x) {
    return std::max(std::abs(left.dot(x)), std::abs(right.dot(x)));
  };
  const auto no_knife = [] { return false; };
  EXPECT_NEAR(quadric.minimiser_in(lo, hi)[0], 4, 1e-9);
  EXPECT_NEAR(quadric.minimiser_in(lo, hi, PrimalQuadric::kFineCutoff)[0], 0, 1e-9);
  EXPECT_NEAR(minimiser_within(quadric, lo, hi, 1, residual, no_knife).point[0], 4, 1e-9);
  EXPECT_NEAR(minimiser_within(quadric, lo, hi, 0.01, residual, no_knife).point[0], 0, 1e-9);
}

// A knife of three degrees: its sides are nearly one plane, too, but face away from each other.
TEST(PrimalQuadric, TheEdgeOfAKnifeIsWhereItsSidesMeet) {
  const Plane left{Vec3(0.05, 0, 1).normalized(), 0};
  const Plane right{Vec3(0.05, 0, -1).normalized(), 0};
  const std::vector<const Plane*> planes{&left, &left, &right};
  ASSERT_TRUE(some_face_away(planes));
  const std::vector<const Plane*> same{&left, &left};
  ASSERT_FALSE(some_face_away(same));
  const auto at = [&](const Vec3& centre, bool knife) {
    PrimalQuadric quadric(centre);
    for (const Plane* plane : planes) quadric.add(*plane);
    const auto residual = [&](const Vec3& x) {
      return std::max(left.distance(x), right.distance(x));
    };
    return minimiser_within(quadric, Vec3(-10, -10, -10), Vec3(10, 10, 10), 1, residual,
                            [&] { return knife; })
        .point;
  };
  EXPECT_NEAR(at(Vec3(-4, 2, 0), true)[0], 0, 1e-9);
  EXPECT_NEAR(at(Vec3(-4, 2, 0), true)[1], 2, 1e-9) << "along the edge it stays where it was";
  EXPECT_NEAR(at(Vec3(-4, 2, 0), false)[0], -4, 0.01);
}

}  // namespace
}  // namespace kdm
