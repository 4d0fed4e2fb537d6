// SPDX-License-Identifier: MIT
#include "reduce/cell_bits.h"

#include <gtest/gtest.h>

#include "geometry/distance.h"
#include "support/random.h"

namespace kdm {
namespace {

constexpr double kWidth = 0.01;

TEST(CellBits, MarksWhatIsNearToASegment) {
  check::Random random(5);
  for (int round = 0; round < 20; ++round) {
    const Vec3 from = random.point(-1, 1);
    const Vec3 to = from + (round % 2 == 0 ? 1 : 0.01) * random.point(-1, 1);
    const CellBits bits({Vec3::Constant(-2), Vec3::Constant(2)}, kWidth, {{from, to}});
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
  // Rows of 70 cubes need two words each; what is marked at the end of one must not go to the next.
  const Vec3 at_the_end(0.65, 0.3, 0.3);
  const CellBits bits({Vec3::Zero(), Vec3::Constant(0.65)}, kWidth, {{at_the_end, at_the_end}});
  EXPECT_TRUE(bits.test(at_the_end));
  for (const double y : {0.28, 0.29, 0.3, 0.31, 0.32}) {
    EXPECT_FALSE(bits.test(Vec3(-0.015, y, 0.3))) << y;
    EXPECT_FALSE(bits.test(Vec3(0.005, y, 0.3))) << y;
  }
}

TEST(CellBits, KnowsNothingOutside) {
  const CellBits bits({Vec3::Zero(), Vec3::Ones()}, kWidth, {{Vec3::Zero(), Vec3::Ones()}});
  EXPECT_TRUE(bits.test(Vec3::Ones()));
  EXPECT_FALSE(bits.test(Vec3(-1, 0, 0)));
  EXPECT_FALSE(bits.test(Vec3(1e300, 0, 0)));
  EXPECT_FALSE(CellBits().test(Vec3::Zero()));
}

TEST(CellBits, HoldsAPoint) {
  const CellBits bits({Vec3::Ones(), Vec3::Ones()}, 0, {{Vec3::Ones(), Vec3::Ones()}});
  EXPECT_TRUE(bits.test(Vec3::Ones()));
}

}  // namespace
}  // namespace kdm
