// SPDX-License-Identifier: MIT
#include "geometry/triangle_distance.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "support/random.h"

namespace kdm {
namespace {

using Corners = std::array<Vec3, 3>;

TEST(TriangleDistance, OfTrianglesThatCrossIsNothing) {
  const Corners flat{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)};
  EXPECT_EQ(squared_distance(flat, Corners{Vec3(0.2, 0.2, -1), Vec3(0.3, 0.2, 1), Vec3(5, 5, 1)}),
            0);
  EXPECT_NEAR(squared_distance(flat, Corners{Vec3(0.2, 0.2, 0), Vec3(0.3, 0.2, 1), Vec3(5, 5, 1)}),
              0, 1e-24);
  EXPECT_NEAR(squared_distance(flat, Corners{Vec3(0.2, 0.2, 3), Vec3(9, 0, 4), Vec3(0, 9, 4)}), 9,
              1e-12);
}

// Turned out of the axes, points of one plane are off it by rounding, on either side.
TEST(TriangleDistance, OfTrianglesInOnePlaneIsThatOfTheirSides) {
  check::Random random(7);
  for (int i = 0; i < 2000; ++i) {
    const Eigen::AngleAxisd turn(random.between(0, 6), random.direction());
    const auto at = [&](double x, double y) { return Vec3(turn * Vec3(x, y, 0.3)); };
    const double gap = random.between(1e-3, 1);
    const Corners left{at(-1, random.unit()), at(0, -1), at(0, 1)};
    const Corners right{at(gap, -random.unit()), at(gap, random.unit()), at(3, random.unit())};
    EXPECT_NEAR(squared_distance(left, right), gap * gap, 1e-9);
  }
}

}  // namespace
}  // namespace kdm
