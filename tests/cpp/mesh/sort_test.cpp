// SPDX-License-Identifier: MIT
// Sorts of short and long ranges, which go different ways.
#include "mesh/sort.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <functional>
#include <random>
#include <utility>
#include <vector>

namespace kdm {
namespace {

struct Item {
  int key;
  std::size_t place;
};

TEST(Sort, EqualElementsKeepTheirOrder) {
  std::mt19937 random(1);
  for (std::size_t size = 0; size < 200; ++size) {
    for (const int keys : {1, 3, 1000}) {
      std::vector<Item> items;
      while (items.size() < size) {
        items.push_back({static_cast<int>(random()) % keys, items.size()});
      }
      std::vector<Item> expected = items;
      const auto less = [](const Item& a, const Item& b) { return a.key < b.key; };
      std::stable_sort(expected.begin(), expected.end(), less);
      sort_by(items, less);
      for (std::size_t i = 0; i < size; ++i) ASSERT_EQ(items[i].place, expected[i].place);
    }
  }
}

TEST(Sort, SortedAndTurnedRanges) {
  for (const int size : {1, 2, 24, 25, 64, 1000}) {
    std::vector<int> up;
    for (int i = 0; i < size; ++i) up.push_back(i);
    std::vector<int> numbers = up;
    sort_up(numbers);
    EXPECT_EQ(numbers, up);
    sort_by(numbers, std::greater<int>());
    EXPECT_EQ(numbers, std::vector<int>(up.rbegin(), up.rend()));
    sort_up(numbers);
    EXPECT_EQ(numbers, up);
  }
}

TEST(Sort, PartsAndArrays) {
  std::vector<int> numbers = {3, 2, 1, 0};
  sort_up(std::span(numbers).subspan(1, 2));
  EXPECT_EQ(numbers, (std::vector<int>{3, 1, 2, 0}));
  std::array<std::pair<int, double>, 3> pairs{{{1, 2.0}, {0, 5.0}, {1, 1.0}}};
  sort_up(pairs);
  EXPECT_EQ(pairs[0].first, 0);
  EXPECT_EQ(pairs[1].second, 1.0);
}

TEST(Sort, Numbers) {
  std::vector<Index> numbers = {5, 1, kNone, 5, 0, 1};
  std::vector<Index> set = numbers;
  sort_numbers(numbers);
  EXPECT_EQ(numbers, (std::vector<Index>{0, 1, 1, 5, 5, kNone}));
  make_set(set);
  EXPECT_EQ(set, (std::vector<Index>{0, 1, 5, kNone}));
  std::vector<std::uint64_t> large = {std::uint64_t{1} << 40, 7, std::uint64_t{1} << 63};
  sort_numbers(large);
  EXPECT_EQ(large, (std::vector<std::uint64_t>{7, std::uint64_t{1} << 40, std::uint64_t{1} << 63}));
}

TEST(Sort, PackedPairsGoByBothNumbers) {
  EXPECT_LT(pack_pair(-1, 5), pack_pair(0, 0));
  EXPECT_LT(pack_pair(-2, 0), pack_pair(-1, 0));
  EXPECT_LT(pack_pair(7, 1), pack_pair(7, kNone));
  EXPECT_EQ(first_of_pair(pack_pair(-3, 9)), -3);
  EXPECT_EQ(second_of_pair(pack_pair(-3, 9)), 9u);
}

}  // namespace
}  // namespace kdm
