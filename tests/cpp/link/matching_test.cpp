// SPDX-License-Identifier: MIT
// The cheapest non-crossing pairing against all of them.
#include "link/matching.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "support/random.h"

namespace kdm {
namespace {

using Matching = std::vector<Index>;

// Every way to pair the points open[0], open[1], ... without crossings: the first takes any partner
// that leaves an even number on both sides.
void enumerate(const std::vector<std::pair<Index, Index>>& open, Matching& partner,
               std::vector<Matching>& all) {
  std::vector<std::pair<Index, Index>> rest = open;
  while (!rest.empty() && rest.back().first == rest.back().second) rest.pop_back();
  if (rest.empty()) {
    all.push_back(partner);
    return;
  }
  const auto [begin, end] = rest.back();
  rest.pop_back();
  for (Index j = begin + 1; j < end; j += 2) {
    partner[begin] = j;
    partner[j] = begin;
    std::vector<std::pair<Index, Index>> next = rest;
    next.emplace_back(begin + 1, j);
    next.emplace_back(j + 1, end);
    enumerate(next, partner, all);
  }
}

std::vector<Matching> all_matchings(Index count) {
  std::vector<Matching> all;
  Matching partner(count, kNone);
  enumerate({{0, count}}, partner, all);
  return all;
}

double total(const Matching& partner, const std::vector<double>& cost) {
  double sum = 0;
  for (Index i = 0; i < partner.size(); ++i) {
    if (partner[i] > i) sum += cost[i * partner.size() + partner[i]];
  }
  return sum;
}

void expect_valid(const Matching& partner) {
  for (Index i = 0; i < partner.size(); ++i) {
    ASSERT_LT(partner[i], partner.size());
    ASSERT_EQ(partner[partner[i]], i);
    ASSERT_EQ((partner[i] + i) % 2, 1u) << "an even number lies between";
    for (Index k = 0; k < partner.size(); ++k) {
      const auto within = [&](Index p) {
        return p > std::min(i, partner[i]) && p < std::max(i, partner[i]);
      };
      if (k == i || k == partner[i]) continue;
      ASSERT_EQ(within(k), within(partner[k])) << "no two pairs cross";
    }
  }
}

TEST(Matching, TheEnumerationFindsCatalanNumbers) {
  EXPECT_EQ(all_matchings(0).size(), 1u);
  EXPECT_EQ(all_matchings(2).size(), 1u);
  EXPECT_EQ(all_matchings(4).size(), 2u);
  EXPECT_EQ(all_matchings(6).size(), 5u);
  EXPECT_EQ(all_matchings(8).size(), 14u);
}

TEST(Matching, IsTheCheapestOfAll) {
  check::Random random(1);
  for (const Index count : {2u, 4u, 6u, 8u}) {
    const std::vector<Matching> all = all_matchings(count);
    for (int round = 0; round < 500; ++round) {
      // Costs spread evenly, few values (ties), and some forbidding ones.
      std::vector<double> cost(count * count);
      for (double& c : cost) {
        c = round % 3 == 0 ? random.unit() : random.below(4);
        if (round % 3 == 2 && random.below(5) == 0) c = 1e30;
      }
      const Matching partner = match_without_crossings(count, [&](Index i, Index j) {
        EXPECT_LT(i, j);
        EXPECT_LT(j, count);
        return cost[i * count + j];
      });
      ASSERT_EQ(partner.size(), count);
      expect_valid(partner);
      double least = std::numeric_limits<double>::infinity();
      for (const Matching& m : all) least = std::min(least, total(m, cost));
      ASSERT_NEAR(total(partner, cost), least, 1e-12 * least + 1e-12)
          << count << " points, round " << round;
    }
  }
}

TEST(Matching, EveryMatchingCanBeChosen) {
  for (const Index count : {2u, 4u, 6u, 8u}) {
    for (const Matching& wanted : all_matchings(count)) {
      const Matching partner = match_without_crossings(
          count, [&](Index i, Index j) { return wanted[i] == j ? 0.0 : 1.0; });
      EXPECT_EQ(partner, wanted);
    }
  }
}

TEST(Matching, WorksForNoneAndForMany) {
  EXPECT_TRUE(match_without_crossings(0, [](Index, Index) { return 0.0; }).empty());
  check::Random random(2);
  const Matching partner = match_without_crossings(64, [&](Index, Index) { return random.unit(); });
  ASSERT_EQ(partner.size(), 64u);
  expect_valid(partner);
}

TEST(Matching, InfiniteCostsStillGiveAMatching) {
  const Matching partner = match_without_crossings(
      6, [](Index, Index) { return std::numeric_limits<double>::infinity(); });
  ASSERT_EQ(partner.size(), 6u);
  expect_valid(partner);
}

TEST(Brackets, NestRoundTheCircle) {
  using Opens = std::vector<bool>;
  EXPECT_TRUE(match_brackets({}).empty());
  EXPECT_EQ(match_brackets(Opens{true, false, true, false}), (Matching{1, 0, 3, 2}));
  EXPECT_EQ(match_brackets(Opens{false, true, false, true}), (Matching{3, 2, 1, 0}));
  EXPECT_EQ(match_brackets(Opens{true, true, false, false}), (Matching{3, 2, 1, 0}));
  EXPECT_EQ(match_brackets(Opens{false, false, true, true}), (Matching{3, 2, 1, 0}));
  EXPECT_EQ(match_brackets(Opens{false, true, true, false}), (Matching{1, 0, 3, 2}));
}

// Infinite costs forbid pairs; where directions are balanced, the cheapest of the rest is found.
TEST(Matching, ForbiddenPairsAreAvoidedWherePossible) {
  constexpr double kNever = std::numeric_limits<double>::infinity();
  check::Random random(3);
  for (const Index count : {2u, 4u, 6u, 8u}) {
    const std::vector<Matching> all = all_matchings(count);
    for (unsigned opens = 0; opens < 1u << count; ++opens) {
      Index open = 0;
      for (Index i = 0; i < count; ++i) open += opens >> i & 1u;
      if (2 * open != count) continue;
      std::vector<double> cost(count * count);
      for (Index i = 0; i < count; ++i) {
        for (Index j = 0; j < count; ++j) {
          const bool fit = (opens >> i & 1u) != (opens >> j & 1u);
          cost[i * count + j] = fit ? random.unit() : kNever;
        }
      }
      const Matching partner =
          match_without_crossings(count, [&](Index i, Index j) { return cost[i * count + j]; });
      expect_valid(partner);
      double least = kNever;
      for (const Matching& m : all) least = std::min(least, total(m, cost));
      ASSERT_LT(least, kNever);
      ASSERT_NEAR(total(partner, cost), least, 1e-12);
    }
  }
}

// Of all matchings without crossings and with points left alone, the least (alone, cost).
struct Brute {
  std::function<bool(Index, Index)> may_pair;
  std::function<double(Index, Index)> cost;

  std::pair<Index, double> least(Index begin, Index end) const {
    if (begin == end) return {0, 0};
    auto best = least(begin + 1, end);
    ++best.first;
    for (Index j = begin + 1; j < end; ++j) {
      if (!may_pair(begin, j)) continue;
      const auto within = least(begin + 1, j);
      const auto after = least(j + 1, end);
      best = std::min(best,
                      {within.first + after.first, cost(begin, j) + within.second + after.second});
    }
    return best;
  }
};

TEST(Matching, SomePairsAreTheMostAndOfThoseTheCheapest) {
  check::Random random(3);
  for (int round = 0; round < 600; ++round) {
    const Index count = random.below(9);
    std::vector<char> side(count);
    for (char& s : side) s = random.coin() ? 1 : 0;
    std::vector<double> cost(count * count);
    for (double& c : cost) c = round % 2 == 0 ? random.unit() : random.below(4);
    const Brute brute{[&](Index i, Index j) { return side[i] != side[j]; },
                      [&](Index i, Index j) { return cost[i * count + j]; }};
    const Matching partner = match_some(count, brute.may_pair, brute.cost);
    ASSERT_EQ(partner.size(), count);
    Index alone = 0;
    double sum = 0;
    for (Index i = 0; i < count; ++i) {
      if (partner[i] == kNone) {
        ++alone;
        continue;
      }
      ASSERT_EQ(partner[partner[i]], i);
      ASSERT_NE(side[i], side[partner[i]]);
      if (partner[i] > i) sum += cost[i * count + partner[i]];
      for (Index k = 0; k < count; ++k) {
        if (partner[k] == kNone || k == i || k == partner[i]) continue;
        const auto within = [&](Index p) {
          return p > std::min(i, partner[i]) && p < std::max(i, partner[i]);
        };
        ASSERT_EQ(within(k), within(partner[k])) << "no two pairs cross";
      }
    }
    const auto [least_alone, least_cost] = brute.least(0, count);
    ASSERT_EQ(alone, least_alone) << "round " << round;
    ASSERT_NEAR(sum, least_cost, 1e-12) << "round " << round;
  }
}

TEST(Matching, SomePairsOfVeryManyAreMadeLikeBrackets) {
  const auto opposite = [](Index i, Index j) { return (i < 200) != (j < 200); };
  const Matching partner = match_some(400, opposite, [](Index, Index) { return 1.0; });
  for (Index i = 0; i < 400; ++i) EXPECT_EQ(partner[i], 399 - i);
  const Matching none = match_some(
      300, [](Index, Index) { return false; }, [](Index, Index) { return 0.0; });
  EXPECT_EQ(none, Matching(300, kNone));
}

}  // namespace
}  // namespace kdm
