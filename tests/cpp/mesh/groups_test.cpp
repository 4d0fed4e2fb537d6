// SPDX-License-Identifier: MIT
// Numbers in groups keep their order.
#include "mesh/groups.h"

#include <gtest/gtest.h>

namespace kdm {
namespace {

std::vector<Index> group(const Groups& groups, Index number) {
  const std::span<const Index> items = groups.of(number);
  return {items.begin(), items.end()};
}

TEST(Groups, KeepTheOrderInWhichItemsCome) {
  const Groups groups(4, [](const auto& put) {
    put(2, 7);
    put(0, 9);
    put(2, 3);
    put(2, 7);
  });
  EXPECT_EQ(group(groups, 0), (std::vector<Index>{9}));
  EXPECT_EQ(group(groups, 1), (std::vector<Index>{}));
  EXPECT_EQ(group(groups, 2), (std::vector<Index>{7, 3, 7}));
  EXPECT_EQ(group(groups, 3), (std::vector<Index>{}));
}

TEST(Groups, MayAllBeEmpty) {
  const Groups groups(2, [](const auto&) {});
  EXPECT_TRUE(group(groups, 0).empty());
  EXPECT_TRUE(group(groups, 1).empty());
}

}  // namespace
}  // namespace kdm
