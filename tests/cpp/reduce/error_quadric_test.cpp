// SPDX-License-Identifier: MIT
#include "reduce/error_quadric.h"

#include <gtest/gtest.h>

namespace kdm {
namespace {

TEST(ErrorQuadric, SumsSquaredDistances) {
  ErrorQuadric quadric;
  quadric.add_plane(Vec3(1, 0, 0), 2, 3);  // x = 2, three times
  quadric.add_plane(Vec3(0, 0, 1), -1, 1);
  EXPECT_DOUBLE_EQ(quadric.error(Vec3(2, 7, -1)), 0);
  EXPECT_DOUBLE_EQ(quadric.error(Vec3(4, 7, 2)), 3 * 4 + 9);
  EXPECT_DOUBLE_EQ(quadric.weight(), 4);
  ErrorQuadric twice = quadric;
  twice += quadric;
  EXPECT_DOUBLE_EQ(twice.error(Vec3(4, 7, 2)), 2 * (3 * 4 + 9));
}

TEST(ErrorQuadric, IsLeastWhereThePlanesMeet) {
  ErrorQuadric quadric;
  quadric.add_plane(Vec3(1, 0, 0), 2, 1);
  quadric.add_plane(Vec3(0, 1, 0), 3, 0.1);
  quadric.add_plane(Vec3(0, 0, 1), 4, 10);
  EXPECT_LT((quadric.minimiser(Vec3(2.5, 2.5, 2.5)) - Vec3(2, 3, 4)).norm(), 1e-3);
}

// Where the planes leave directions open, the nearest of the points that serve is taken.
TEST(ErrorQuadric, StaysNearTheCentre) {
  ErrorQuadric edge;
  edge.add_plane(Vec3(1, 0, 0), 2, 1);
  edge.add_plane(Vec3(0, 1, 0), 3, 1);
  EXPECT_LT((edge.minimiser(Vec3(2.5, 2.5, 9)) - Vec3(2, 3, 9)).norm(), 1e-4);
  ErrorQuadric flat;
  flat.add_plane(Vec3(0, 0, 1), 5, 1);
  EXPECT_LT((flat.minimiser(Vec3(1, 2, 3)) - Vec3(1, 2, 5)).norm(), 1e-4);
  EXPECT_EQ(ErrorQuadric().minimiser(Vec3(1, 2, 3)), Vec3(1, 2, 3));
}

}  // namespace
}  // namespace kdm
