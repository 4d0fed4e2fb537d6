// SPDX-License-Identifier: MIT
// Which part of a segment lies in a box.
#include "geometry/segment_box.h"

#include <gtest/gtest.h>

namespace kdm {
namespace {

const LatticeBox kBox{{10, 20, 30}, {20, 40, 60}};

TEST(SegmentBox, ASegmentWithinHasBothEndsInIt) {
  const auto part = segment_in_box(Vec3(11, 22, 33), Vec3(19, 38, 57), kBox);
  ASSERT_TRUE(part);
  EXPECT_TRUE(part->meets);
  EXPECT_TRUE(part->ends_in[0] && part->ends_in[1]);
  EXPECT_EQ(part->ends[0], Vec3(11, 22, 33));
  EXPECT_EQ(part->ends[1], Vec3(19, 38, 57));
}

TEST(SegmentBox, NamesTheFaceBeyondEachEnd) {
  for (int axis = 0; axis < 3; ++axis) {
    Vec3 low(15, 30, 45);
    Vec3 high = low;
    low[axis] = 0;
    high[axis] = 100;
    const auto through = segment_in_box(low, high, kBox);
    ASSERT_TRUE(through && through->meets);
    EXPECT_EQ(through->leaves_by[0], 2 * axis);
    EXPECT_EQ(through->leaves_by[1], 2 * axis + 1);
    EXPECT_NEAR(through->ends[0][axis], kBox.lo[axis], 1e-5);
    EXPECT_NEAR(through->ends[1][axis], kBox.hi[axis], 1e-5);
    const auto back = segment_in_box(high, Vec3(15, 30, 45), kBox);
    ASSERT_TRUE(back && back->meets);
    EXPECT_FALSE(back->ends_in[0]);
    EXPECT_TRUE(back->ends_in[1]);
    EXPECT_EQ(back->leaves_by[0], 2 * axis + 1);
  }
}

TEST(SegmentBox, ASegmentBesideItDoesNotMeetIt) {
  const auto far = segment_in_box(Vec3(0, 0, 0), Vec3(100, 0, 0), kBox);
  ASSERT_TRUE(far);
  EXPECT_FALSE(far->meets);
  const auto past_an_edge = segment_in_box(Vec3(8, 21, 45), Vec3(12, 17, 45), kBox);
  ASSERT_TRUE(past_an_edge);
  EXPECT_FALSE(past_an_edge->meets);
}

// Grid points are shifted upwards: what lies in the plane of a face is below that plane.
TEST(SegmentBox, InThePlaneOfAFaceItIsBelowThatFace) {
  const auto low = segment_in_box(Vec3(10, 25, 40), Vec3(10, 35, 50), kBox);
  ASSERT_TRUE(low);
  EXPECT_FALSE(low->meets);
  const auto high = segment_in_box(Vec3(20, 25, 40), Vec3(20, 35, 50), kBox);
  ASSERT_TRUE(high);
  EXPECT_TRUE(high->meets);
  EXPECT_TRUE(high->ends_in[0] && high->ends_in[1]);
}

TEST(SegmentBox, GivesNoAnswerWhereRoundingWouldGiveIt) {
  const Vec3 edge(20 + 4e-6, 20 + 2e-6, 45);  // the box's edge, as it is shifted
  EXPECT_FALSE(segment_in_box(edge - Vec3(5, 5, 0), edge + Vec3(5, 5, 0), kBox));
  EXPECT_FALSE(segment_in_box(edge + Vec3(0, 5, 0), edge + Vec3(0, 15, 0), kBox));
  EXPECT_FALSE(segment_in_box(edge + Vec3(-5, 5, 0), edge + Vec3(0, 5, 0), kBox));
  EXPECT_TRUE(segment_in_box(edge + Vec3(-5, 5, 0), edge + Vec3(1e-6, 5, 0), kBox));
}

}  // namespace
}  // namespace kdm
