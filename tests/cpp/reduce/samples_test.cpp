// SPDX-License-Identifier: MIT
#include "reduce/samples.h"

#include <gtest/gtest.h>

namespace kdm {
namespace {

// Two triangles 5 and 6 of a square, whose diagonal has been collapsed out of four; 7 and 8 go.
CollapseRing square(double height) {
  CollapseRing ring;
  ring.kept = 0;
  ring.removed = 1;
  ring.point = Vec3(0, 0, height);
  ring.triangles = {{5, 2, 3, kNone, Vec3(1, 0, 0), Vec3(1, 1, 0), Vec3(0, 0, 0)},
                    {6, 3, 4, kNone, Vec3(1, 1, 0), Vec3(0, 1, 0), Vec3(0, 0, 0)}};
  ring.gone = {7, 8};
  return ring;
}

TEST(Samples, FitOnlyWithinTheDistance) {
  Samples samples(9);
  Samples::Places to;
  samples.add(Vec3(0.5, 0.2, 0.1), 5, 40);
  EXPECT_TRUE(samples.fit(square(0), 0.11, to));
  EXPECT_FALSE(samples.fit(square(0), 0.09, to));
}

TEST(Samples, OfTrianglesThatGoMoveToThoseThatStay) {
  Samples samples(9);
  Samples::Places to;
  samples.add(Vec3(0.6, 0.2, 0), 7, 40);
  samples.add(Vec3(0.2, 0.6, 0), 8, 41);
  ASSERT_TRUE(samples.fit(square(0), 0.01, to));
  EXPECT_EQ(to.hint(0), 40u);
  EXPECT_EQ(to.hint(1), 41u);
  samples.move(square(0), to);
  // They are at the new triangles now: a peak under one of them leaves only its own behind.
  CollapseRing first = square(0);
  first.triangles.resize(1);
  first.gone = {8, 8};
  EXPECT_TRUE(samples.fit(first, 0.01, to));
  CollapseRing moved = square(-1);
  moved.triangles[0].number = 6;
  moved.triangles.resize(1);
  moved.gone = {7, 8};
  EXPECT_FALSE(samples.fit(moved, 0.1, to));
}

TEST(Samples, OfFlippedTrianglesGoToTheNearerOne) {
  Samples samples(9);
  Samples::Places to;
  samples.add(Vec3(0.6, 0.2, 0), 5, 40);
  samples.add(Vec3(0.2, 0.6, 0), 5, 41);
  const std::array<TriangleId, 2> places = {5, 6};
  const std::array<std::array<Vec3, 3>, 2> corners = {
      std::array<Vec3, 3>{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 1, 0)},
      std::array<Vec3, 3>{Vec3(0, 0, 0), Vec3(1, 1, 0), Vec3(0, 1, 0)}};
  ASSERT_TRUE(samples.fit(places, corners, 0.01, to));
  samples.move(places, to);
  CollapseRing only_second = square(0);
  only_second.triangles = {only_second.triangles[1]};
  only_second.gone = {7, 8};
  EXPECT_TRUE(samples.fit(only_second, 0.01, to));
  only_second.gone = {5, 5};
  EXPECT_FALSE(samples.fit(only_second, 0.01, to));
}

}  // namespace
}  // namespace kdm
