// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>

#include "geometry/quadric.h"
#include "simplify/dual_quadric.h"

namespace kdm {
namespace {

DualQuadric point(double x, double y, double z) { return {Vec3(x, y, z), Vec3::UnitZ(), 0}; }

TEST(DualQuadric, IsZeroForPointsOfAPlane) {
  DualQuadric sum;
  for (int i = 0; i < 9; ++i) {
    const int x = i % 3;
    const int y = i / 3;
    sum.add(point(1e6 + x, 1e6 + y, 1e6 + 0.5 * x - y));
  }
  EXPECT_NEAR(sum.least_error(), 0, 1e-9);
}

// Four corners of a square, two of them lifted by 1: the best plane is half as high.
TEST(DualQuadric, IsTheMeanSquaredDistance) {
  const double far = 5e5;
  DualQuadric sum;
  sum.add(point(far, far, 0));
  DualQuadric other;
  other.add(point(far + 100, far, 1));
  other.add(point(far, far + 100, 1));
  other.add(point(far + 100, far + 100, 0));
  sum.add(other);
  EXPECT_NEAR(sum.least_error(), 0.25, 1e-6);
}

TEST(DualQuadric, KnowsThePlaneOfOneDisk) {
  DualQuadric disk(Vec3(1, 2, 3), Vec3::UnitX(), 2);
  EXPECT_NEAR(disk.least_error(), 0, 1e-12);
  disk.add({Vec3(1, 2, 5), Vec3::UnitX(), 2});
  EXPECT_NEAR(disk.least_error(), 0, 1e-12);
  disk.add({Vec3(4, 2, 4), Vec3::UnitX(), 2});
  EXPECT_GT(disk.least_error(), 0.1);
}

TEST(PrimalQuadric, AddsUpWhateverTheCentres) {
  const Plane a{Vec3::UnitX(), 3};
  const Plane b{Vec3(0.6, 0.8, 0), -1};
  const Plane c{Vec3::UnitZ(), 7};
  PrimalQuadric all(Vec3(1, 1, 1));
  for (const Plane& plane : {a, b, c}) all.add(plane);
  PrimalQuadric sum(Vec3(-4, 0, 9));
  sum.add(a);
  PrimalQuadric rest(Vec3(2, 5, 1));
  rest.add(b);
  rest.add(c);
  sum.add(rest);
  for (const Vec3& x : {Vec3(0, 0, 0), Vec3(3, 2, 1), Vec3(-5, 8, 2)}) {
    EXPECT_NEAR(sum.error(x), all.error(x), 1e-12 * (1 + all.error(x)));
  }
}

}  // namespace
}  // namespace kdm
