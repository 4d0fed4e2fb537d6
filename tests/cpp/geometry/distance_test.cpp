// SPDX-License-Identifier: MIT
#include "geometry/distance.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/random.h"

namespace kdm {
namespace {

// The least distance to points all over the triangle.
double sampled_distance(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  constexpr int kSteps = 60;
  double least = 1e9;
  for (int i = 0; i <= kSteps; ++i) {
    for (int j = 0; i + j <= kSteps; ++j) {
      const Vec3 q = a + (double(i) / kSteps) * (b - a) + (double(j) / kSteps) * (c - a);
      least = std::min(least, (p - q).norm());
    }
  }
  return least;
}

TEST(Distance, OfTrianglesIsThatOfTheirNearestPoint) {
  check::Random random(1);
  const auto point = [&] { return random.point(-1, 1); };
  for (int i = 0; i < 400; ++i) {
    const Vec3 a = point();
    const Vec3 b = point();
    const Vec3 c = point();
    const Vec3 p = 2 * point();
    const double distance = std::sqrt(squared_distance(p, a, b, c));
    const double sampled = sampled_distance(p, a, b, c);
    EXPECT_LE(distance, sampled + 1e-12);
    EXPECT_GE(distance, sampled - 0.05);
    EXPECT_NEAR(std::sqrt(squared_distance(a, a, b, c)), 0, 1e-12);
    EXPECT_NEAR(std::sqrt(squared_distance((a + b + c) / 3, a, b, c)), 0, 1e-12);
  }
}

TEST(Distance, OfTrianglesWithoutAreaIsThatOfASegmentOrPoint) {
  const Vec3 a(0, 0, 0);
  const Vec3 b(2, 0, 0);
  const Vec3 c(1, 0, 0);
  const Vec3 p(1.5, 3, 0);
  EXPECT_DOUBLE_EQ(squared_distance(p, a, b, c), 9);
  EXPECT_DOUBLE_EQ(squared_distance(p, b, c, a), 9);
  EXPECT_DOUBLE_EQ(squared_distance(p, c, a, b), 9);
  EXPECT_DOUBLE_EQ(squared_distance(Vec3(3, 0, 0), a, b, c), 1);
  EXPECT_DOUBLE_EQ(squared_distance(p, a, a, b), 9);
  EXPECT_DOUBLE_EQ(squared_distance(p, a, a, a), 1.5 * 1.5 + 9);
}

}  // namespace
}  // namespace kdm
