// SPDX-License-Identifier: MIT
#include "mesh/small_box.h"

#include <gtest/gtest.h>

#include "support/random.h"

namespace kdm {
namespace {

TEST(SmallBox, IsNeverSmallerThanItsPoints) {
  check::Random random(3);
  for (int i = 0; i < 1000; ++i) {
    const Vec3 p = random.point(-1, 1);
    SmallBox box;
    box.grow(p);
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_LE(box.min[axis], p[axis]);
      EXPECT_GE(box.max[axis], p[axis]);
    }
  }
}

TEST(SmallBox, MeetsWhatTouchesIt) {
  const SmallBox box = small_box(Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0));
  EXPECT_TRUE(box.meets(small_box(Vec3(1, 1, 0), Vec3(2, 1, 0), Vec3(1, 2, 0))));
  for (int axis = 0; axis < 3; ++axis) {
    const Vec3 away = 1.001 * Vec3::Unit(axis);
    const SmallBox other = small_box(away, away + Vec3(1, 0, 0), away + Vec3(0, 1, 0));
    EXPECT_FALSE(box.meets(other)) << axis;
    EXPECT_FALSE(other.meets(box)) << axis;
  }
}

}  // namespace
}  // namespace kdm
