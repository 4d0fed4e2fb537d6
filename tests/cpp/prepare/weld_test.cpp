// SPDX-License-Identifier: MIT
// Joining equal positions, against a map.
#include "prepare/weld.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <tuple>

#include "support/random.h"
#include "support/shapes.h"

namespace kdm {
namespace {

TEST(Weld, NumbersPointsByFirstUse) {
  const Vec3 a(1, 2, 3);
  const Vec3 b(3, 2, 1);
  const Vec3 c(0, 0, 0);
  const Weld weld = weld_positions({b, a, b, c, a, a});
  EXPECT_EQ(weld.point_of, (std::vector<Index>{0, 1, 0, 2, 1, 1}));
  EXPECT_EQ(weld.first_of, (std::vector<Index>{0, 1, 3}));
}

TEST(Weld, NothingGivesNothing) {
  const Weld weld = weld_positions({});
  EXPECT_TRUE(weld.point_of.empty());
  EXPECT_TRUE(weld.first_of.empty());
}

TEST(Weld, MinusZeroIsZero) {
  const Weld weld = weld_positions({Vec3(0, -0.0, 1), Vec3(-0.0, 0, 1), Vec3(-0.0, -0.0, 1)});
  EXPECT_EQ(weld.first_of.size(), 1u);
}

TEST(Weld, TheSmallestDifferenceCounts) {
  const double next = std::nextafter(1.0, 2.0);
  const Weld weld = weld_positions({Vec3(1, 1, 1), Vec3(1, next, 1), Vec3(1, 1, 1)});
  EXPECT_EQ(weld.point_of, (std::vector<Index>{0, 1, 0}));
  EXPECT_EQ(weld_positions({Vec3(0, 0, 0), Vec3(0, 0, 5e-324)}).first_of.size(), 2u);
}

TEST(Weld, AgreesWithAMap) {
  check::Random random(1);
  for (const std::uint32_t range : {2u, 10u, 1000u}) {
    std::vector<Vec3> positions;
    for (int i = 0; i < 3000; ++i) {
      const double x = random.below(range);
      const double y = random.below(range);
      positions.emplace_back(x - 1, y * 0.125, random.below(3) - 1.0);
    }
    const Weld weld = weld_positions(positions);
    std::map<std::tuple<double, double, double>, Index> number;
    ASSERT_EQ(weld.point_of.size(), positions.size());
    for (std::size_t i = 0; i < positions.size(); ++i) {
      const Vec3& p = positions[i];
      const auto [entry, fresh] =
          number.try_emplace({p[0], p[1], p[2]}, static_cast<Index>(number.size()));
      ASSERT_EQ(weld.point_of[i], entry->second);
      if (fresh) {
        ASSERT_EQ(weld.first_of[entry->second], i);
      }
    }
    ASSERT_EQ(weld.first_of.size(), number.size());
  }
}

TEST(Weld, ASoupGetsItsVerticesBack) {
  const Mesh torus = shapes::torus();
  EXPECT_EQ(weld_positions(shapes::soup(torus).positions).first_of.size(), torus.positions.size());
}

}  // namespace
}  // namespace kdm
