// SPDX-License-Identifier: MIT
#include "mesh/marks.h"

#include <gtest/gtest.h>

namespace kdm {
namespace {

TEST(Marks, AreUnmarkedAtFirst) {
  const Marks marks(3);
  EXPECT_EQ(marks.size(), 3u);
  EXPECT_EQ(marks.count(), 0u);
  EXPECT_FALSE(marks.any());
  for (std::size_t i = 0; i < 3; ++i) EXPECT_FALSE(marks.test(i));
  EXPECT_TRUE(Marks().empty());
}

TEST(Marks, AreSetAndClearedByNumber) {
  Marks marks(4);
  marks.set(1);
  marks.set(2, true);
  marks.set(3);
  marks.set(3, false);
  EXPECT_EQ(marks.count(), 2u);
  EXPECT_TRUE(marks.any());
  EXPECT_FALSE(marks.test(0));
  EXPECT_TRUE(marks.test(1));
  EXPECT_TRUE(marks.test(2));
  EXPECT_FALSE(marks.test(3));
  marks.clear(1);
  EXPECT_FALSE(marks.test(1));
  marks.clear_all();
  EXPECT_EQ(marks, Marks(4));
}

TEST(Marks, TellWhetherANumberWasMarkedBefore) {
  Marks marks(2);
  EXPECT_FALSE(marks.test_and_set(1));
  EXPECT_TRUE(marks.test_and_set(1));
  EXPECT_TRUE(marks.test(1));
  EXPECT_FALSE(marks.test(0));
}

// Not inlined: GCC 12 takes the growth of a vector for an overflow where it knows all sizes.
[[gnu::noinline]] void resize(Marks& marks, std::size_t size) { marks.resize(size); }

TEST(Marks, KeepFlagsWhenResizedAndLoseThemWhenAssigned) {
  Marks marks;
  marks.push_back(true);
  resize(marks, 2);
  EXPECT_TRUE(marks.test(0));
  EXPECT_FALSE(marks.test(1));
  marks.push_back(true);
  EXPECT_EQ(marks.size(), 3u);
  EXPECT_TRUE(marks.test(2));
  marks.assign(2);
  EXPECT_EQ(marks, Marks(2));
}

}  // namespace
}  // namespace kdm
