// SPDX-License-Identifier: MIT
#include "mesh/four_boxes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "support/random.h"

namespace kdm {
namespace {

SmallBox random_box(check::Random& random) {
  return small_box(random.point(-1, 1), 0.4 * random.between(0, 1));
}

TEST(FourBoxes, SayWhatEachSays) {
  check::Random random(4);
  int meeting = 0;
  for (int round = 0; round < 1000; ++round) {
    std::array<SmallBox, 4> boxes;
    FourBoxes four;
    SmallBox around;
    for (int i = 0; i < 4; ++i) {
      if (round % 5 == i) continue;  // stays empty
      boxes[i] = random_box(random);
      four.set(i, boxes[i]);
      around.grow(boxes[i]);
    }
    const SmallBox other = random_box(random);
    FourBoxes::Bits bits = 0;
    for (int i = 0; i < 4; ++i) {
      EXPECT_EQ(four[i], boxes[i]);
      if (boxes[i].meets(other)) bits |= 1u << i;
    }
    EXPECT_EQ(four.meeting(FourBoxes::Same(other)), bits);
    EXPECT_EQ(four.around(), around);
    meeting += bits != 0 ? 1 : 0;
  }
  EXPECT_GT(meeting, 100);
  EXPECT_LT(meeting, 900);
}

TEST(FourBoxes, TouchingBoxesMeet) {
  const SmallBox box = {{0, 0, 0}, {1, 1, 1}};
  FourBoxes four;
  four.set(0, {{1, 1, 1}, {2, 2, 2}});
  four.set(1, {{-1, -1, -1}, {0, 0, 0}});
  four.set(2, {{1.5, 0, 0}, {2, 1, 1}});
  four.set(3, {{0, 0, -2}, {1, 1, -1}});
  EXPECT_EQ(four.meeting(FourBoxes::Same(box)), 0b0011u);
}

TEST(FourBoxes, EmptyOnesMeetNothing) {
  FourBoxes four;
  four.set(2, {{0, 0, 0}, {1, 1, 1}});
  const SmallBox all = small_box(Vec3::Zero(), std::numeric_limits<double>::infinity());
  EXPECT_EQ(four.meeting(FourBoxes::Same(all)), 0b0100u);
  EXPECT_EQ(four.meeting(FourBoxes::Same(SmallBox{})), 0u);
}

TEST(FourBoxes, KnowHowFarAPointIs) {
  check::Random random(5);
  for (int round = 0; round < 1000; ++round) {
    const Vec3 p = random.point(-1, 1);
    FourBoxes four;
    std::array<SmallBox, 3> boxes;
    for (int i = 0; i < 3; ++i) {
      boxes[i] = random_box(random);
      four.set(i, boxes[i]);
    }
    const std::array<float, 4> gaps = four.squared_gaps(FourBoxes::Same(small_box(p, 0)));
    for (int i = 0; i < 3; ++i) {
      Vec3 off;
      for (int axis = 0; axis < 3; ++axis) {
        off[axis] = std::max({boxes[i].min[axis] - p[axis], p[axis] - boxes[i].max[axis], 0.0});
      }
      EXPECT_NEAR(std::sqrt(gaps[i]), off.norm(), 1e-6) << i;
    }
    EXPECT_EQ(gaps[3], SmallBox::kFar);
  }
}

}  // namespace
}  // namespace kdm
