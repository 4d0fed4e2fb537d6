// SPDX-License-Identifier: MIT
// Points near all planes, where some planes count so often that squares lead elsewhere.
#include <gtest/gtest.h>

#include "geometry/quadric.h"
#include "support/random.h"

namespace kdm {
namespace {

using check::Random;

const Vec3 kBoxLow(-10, -10, -10);
const Vec3 kBoxHigh(10, 10, 10);

double largest_distance(const std::vector<Plane>& planes, const Vec3& x) {
  double largest = 0;
  for (const Plane& plane : planes) largest = std::max(largest, plane.distance(x));
  return largest;
}

TEST(PointWithin, IsFoundWhereOnePlaneCountsManyTimes) {
  std::vector<Plane> planes(9, {Vec3::UnitX(), -1});
  planes.push_back({Vec3::UnitX(), 1});
  const std::optional<Vec3> x = point_within(planes, Vec3(0.5, 2, 3), kBoxLow, kBoxHigh, 1.1);
  ASSERT_TRUE(x.has_value());
  EXPECT_LE(largest_distance(planes, *x), 1.1) << "the mean is at -0.8, 1.8 from one of them";
  EXPECT_EQ(x->y(), 2) << "where no plane says otherwise, at the centre";
  EXPECT_EQ(x->z(), 3);
}

TEST(PointWithin, IsNotMadeUp) {
  const std::vector<Plane> planes{{Vec3::UnitX(), -1}, {Vec3::UnitX(), 1}};
  EXPECT_FALSE(point_within(planes, Vec3::Zero(), kBoxLow, kBoxHigh, 0.9).has_value());
  // One point meets both, but beyond the box.
  const Plane far{Vec3::UnitY(), 30};
  EXPECT_FALSE(point_within(std::vector{far}, Vec3::Zero(), kBoxLow, kBoxHigh, 19).has_value());
  EXPECT_TRUE(point_within(std::vector{far}, Vec3::Zero(), kBoxLow, kBoxHigh, 21).has_value());
}

// Planes that pass a hidden point by up to half of the tolerance, some of them many times.
TEST(PointWithin, IsFoundAmongRandomPlanes) {
  Random random(5);
  int found = 0;
  constexpr int kTrials = 300;
  for (int trial = 0; trial < kTrials; ++trial) {
    const Vec3 hidden = random.point(-8, 8);
    std::vector<Plane> planes;
    for (int i = 0; i < 6; ++i) {
      const Vec3 normal = random.direction();
      const Plane plane{normal, normal.dot(hidden) + random.between(-0.5, 0.5)};
      planes.insert(planes.end(), 1 + random.below(20), plane);
    }
    const std::optional<Vec3> x = point_within(planes, random.point(-8, 8), kBoxLow, kBoxHigh, 1);
    if (!x) continue;
    ++found;
    EXPECT_LE(largest_distance(planes, *x), 1);
    EXPECT_TRUE((x->array() >= kBoxLow.array()).all() && (x->array() <= kBoxHigh.array()).all());
  }
  EXPECT_GE(found, kTrials * 99 / 100);
}

}  // namespace
}  // namespace kdm
