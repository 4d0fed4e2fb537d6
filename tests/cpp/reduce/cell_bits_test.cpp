// SPDX-License-Identifier: MIT
#include "reduce/cell_bits.h"

#include <gtest/gtest.h>

#include "geometry/distance.h"
#include "support/random.h"

namespace kdm {
namespace {

constexpr double kWidth = 0.01;

TEST(CellBits, GrownMarksHoldWhatIsNearToASegment) {
  check::Random random(5);
  for (int round = 0; round < 20; ++round) {
    const Vec3 from = random.point(-1, 1);
    const Vec3 to = from + (round % 2 == 0 ? 1 : 0.01) * random.point(-1, 1);
    CellBits bits({Vec3::Constant(-2), Vec3::Constant(2)}, kWidth);
    bits.mark(from, to);
    bits.grow();
    for (int i = 0; i < 500; ++i) {
      const double at = 0.5 + 0.5 * random.point(-1, 1)[0];
      const Vec3 p = from + at * (to - from) + 2.5 * kWidth * random.point(-1, 1);
      const double off = std::sqrt(squared_distance(p, from, to));
      if (off <= 0.5 * kWidth) {
        EXPECT_TRUE(bits.test(p)) << off;
      }
      if (off > 3.5 * kWidth) {
        EXPECT_FALSE(bits.test(p)) << off;
      }
    }
  }
}

TEST(CellBits, TellsRowsApart) {
  // Rows of 70 cubes need two words each; what grows at the end of one must not go to the next.
  CellBits bits({Vec3::Zero(), Vec3(0.65, 0.65, 0.65)}, kWidth);
  bits.mark(Vec3(0.65, 0.3, 0.3), Vec3(0.65, 0.3, 0.3));
  bits.grow();
  EXPECT_TRUE(bits.test(Vec3(0.65, 0.3, 0.3)));
  for (const double y : {0.28, 0.29, 0.3, 0.31, 0.32}) {
    EXPECT_FALSE(bits.test(Vec3(-0.015, y, 0.3))) << y;
    EXPECT_FALSE(bits.test(Vec3(0.005, y, 0.3))) << y;
  }
}

TEST(CellBits, KnowsNothingOutside) {
  CellBits bits({Vec3::Zero(), Vec3::Ones()}, kWidth);
  bits.mark(Vec3::Zero(), Vec3::Ones());
  bits.grow();
  EXPECT_TRUE(bits.test(Vec3::Ones()));
  EXPECT_FALSE(bits.test(Vec3(-1, 0, 0)));
  EXPECT_FALSE(bits.test(Vec3(1e300, 0, 0)));
  EXPECT_FALSE(CellBits().test(Vec3::Zero()));
}

TEST(CellBits, HoldsAPoint) {
  CellBits bits({Vec3::Ones(), Vec3::Ones()}, 0);
  bits.mark(Vec3::Ones(), Vec3::Ones());
  EXPECT_TRUE(bits.test(Vec3::Ones()));
}

}  // namespace
}  // namespace kdm
