// SPDX-License-Identifier: MIT
// The walk along one edge: which crossings bound the solid, for each inside rule.
#include "inside/winding.h"

#include <gtest/gtest.h>

#include <map>
#include <string>

#include "support/random.h"

namespace kdm {
namespace {

constexpr std::array<InsideRule, 3> kRules{InsideRule::kPositive, InsideRule::kOdd,
                                           InsideRule::kNonzero};

// Crossings by their positions, numbered in turn; '<' enters (the normal points down the edge) and
// '>' leaves. The kept ones come back in the same notation.
std::string kept(const std::vector<std::pair<char, LinePosition>>& input, InsideRule rule,
                 int winding_below = 0) {
  std::vector<Crossing> crossings;
  for (const auto& [direction, position] : input) {
    crossings.push_back({position, static_cast<Index>(crossings.size()), direction == '>'});
  }
  std::vector<ClassifiedCrossing> classified;
  classify_crossings(crossings, winding_below, rule, classified);
  std::string text;
  for (const ClassifiedCrossing& c : classified) {
    if (c.kept()) text += (c.leaving() ? '>' : '<') + std::to_string(c.position()) + ' ';
  }
  return text;
}

TEST(Winding, NothingToWalk) {
  std::vector<Crossing> none;
  std::vector<ClassifiedCrossing> classified(
      3, ClassifiedCrossing(1, 2, 3, CrossingRole::kBounds, false));
  EXPECT_EQ(classify_crossings(none, 2, InsideRule::kPositive, classified), 2);
  EXPECT_EQ(classified.size(), 3u) << "what was there before stays";
}

TEST(Winding, ASolidIsEnteredAndLeftUnderEveryRule) {
  for (const InsideRule rule : kRules) {
    EXPECT_EQ(kept({{'<', 10}, {'>', 20}}, rule), "<10 >20 ");
    EXPECT_EQ(kept({{'>', 20}, {'<', 10}}, rule), "<10 >20 ") << "sorted by position";
  }
}

TEST(Winding, NestedShellsAreOneSolidUnlessOddCounts) {
  const std::vector<std::pair<char, LinePosition>> nested{{'<', 1}, {'<', 2}, {'>', 3}, {'>', 4}};
  EXPECT_EQ(kept(nested, InsideRule::kPositive), "<1 >4 ");
  EXPECT_EQ(kept(nested, InsideRule::kNonzero), "<1 >4 ");
  EXPECT_EQ(kept(nested, InsideRule::kOdd), "<1 >2 <3 >4 ");
}

TEST(Winding, ACavityIsLeftOut) {
  const std::vector<std::pair<char, LinePosition>> hollow{{'<', 1}, {'>', 2}, {'<', 3}, {'>', 4}};
  for (const InsideRule rule : kRules) EXPECT_EQ(kept(hollow, rule), "<1 >2 <3 >4 ");
}

TEST(Winding, OverlappingShellsAreTheirUnion) {
  const std::vector<std::pair<char, LinePosition>> chain{{'<', 1}, {'<', 2}, {'>', 3},
                                                         {'<', 4}, {'>', 5}, {'>', 6}};
  EXPECT_EQ(kept(chain, InsideRule::kPositive), "<1 >6 ");
  EXPECT_EQ(kept(chain, InsideRule::kNonzero), "<1 >6 ");
  EXPECT_EQ(kept(chain, InsideRule::kOdd), "<1 >2 <3 >4 <5 >6 ");
}

TEST(Winding, AShellInsideOutIsASolidForOddAndNonzeroOnly) {
  // Its own crossings run the wrong way; the kept ones say what the solid does.
  const std::vector<std::pair<char, LinePosition>> turned{{'>', 1}, {'<', 2}};
  EXPECT_EQ(kept(turned, InsideRule::kPositive), "");
  EXPECT_EQ(kept(turned, InsideRule::kOdd), "<1 >2 ");
  EXPECT_EQ(kept(turned, InsideRule::kNonzero), "<1 >2 ");
}

TEST(Winding, DoubledFacesAreOneHit) {
  const std::vector<std::pair<char, LinePosition>> doubled{{'<', 1}, {'<', 1}, {'>', 9}, {'>', 9}};
  EXPECT_EQ(kept(doubled, InsideRule::kPositive), "<1 >9 ");
  EXPECT_EQ(kept(doubled, InsideRule::kNonzero), "<1 >9 ");
  EXPECT_EQ(kept(doubled, InsideRule::kOdd), "");
}

TEST(Winding, OppositeFacesAtOnePositionVanish) {
  const std::vector<std::pair<char, LinePosition>> flap{{'<', 1}, {'>', 5}, {'<', 5}, {'>', 9}};
  for (const InsideRule rule : kRules) {
    EXPECT_EQ(kept(flap, rule), "<1 >9 ");
    EXPECT_EQ(kept({{'<', 5}, {'>', 5}}, rule), "");
    EXPECT_EQ(kept({{'>', 5}, {'<', 5}}, rule), "");
  }
}

TEST(Winding, TheWalkStartsFromTheWindingBelow) {
  EXPECT_EQ(kept({{'>', 3}}, InsideRule::kPositive, 1), ">3 ");
  EXPECT_EQ(kept({{'>', 3}}, InsideRule::kPositive, 2), "");
  EXPECT_EQ(kept({{'>', 3}}, InsideRule::kPositive, 0), "");
  EXPECT_EQ(kept({{'>', 3}}, InsideRule::kNonzero, 0), "<3 ");
  EXPECT_EQ(kept({{'<', 3}}, InsideRule::kNonzero, -1), ">3 ");
  EXPECT_EQ(kept({{'<', 3}}, InsideRule::kOdd, -3), ">3 ");
}

TEST(Winding, OfSeveralAtOnePositionTheFirstThatFitsIsKept) {
  std::vector<Crossing> crossings{{7, 5, true}, {7, 2, false}, {7, 9, false}, {7, 4, false}};
  std::vector<ClassifiedCrossing> classified;
  EXPECT_EQ(classify_crossings(crossings, 0, InsideRule::kPositive, classified), 2);
  ASSERT_EQ(classified.size(), 4u);
  for (const ClassifiedCrossing& c : classified) {
    EXPECT_EQ(c.kept(), c.triangle() == 2) << c.triangle();
    EXPECT_EQ(c.state_after(), 2);
  }
  // The order in which they were found does not count.
  std::vector<Crossing> reversed{{7, 4, false}, {7, 9, false}, {7, 2, false}, {7, 5, true}};
  classified.clear();
  classify_crossings(reversed, 0, InsideRule::kPositive, classified);
  for (const ClassifiedCrossing& c : classified) EXPECT_EQ(c.kept(), c.triangle() == 2);
}

// The roles of all crossings: b bounds, i inner, t touching, g gap.
std::string roles(const std::vector<std::pair<char, LinePosition>>& input) {
  std::vector<Crossing> crossings;
  for (const auto& [direction, position] : input) {
    crossings.push_back({position, static_cast<Index>(crossings.size()), direction == '>'});
  }
  std::vector<ClassifiedCrossing> classified;
  classify_crossings(crossings, 0, InsideRule::kPositive, classified);
  std::string text;
  for (const ClassifiedCrossing& c : classified) text += "bitg"[static_cast<int>(c.role())];
  return text;
}

TEST(Winding, WhereTwoSolidsMeetTheWallBetweenThemIsInner) {
  EXPECT_EQ(roles({{'<', 1}, {'>', 5}, {'<', 5}, {'>', 9}}), "biib");
}

// The apex of a double cone on a grid edge bounds the solid beside the edge.
TEST(Winding, WhereASolidHasNoWidthItTouches) { EXPECT_EQ(roles({{'<', 5}, {'>', 5}}), "tt"); }

TEST(Winding, ANestedShellIsInner) {
  EXPECT_EQ(roles({{'<', 1}, {'<', 3}, {'>', 5}, {'>', 9}}), "biib");
}

bool inside(InsideRule rule, int winding) {
  if (rule == InsideRule::kPositive) return winding >= 1;
  return rule == InsideRule::kOdd ? std::abs(winding) % 2 == 1 : winding != 0;
}

TEST(Winding, RandomEdgesAgreeWithCountingAtEveryPosition) {
  check::Random random(1);
  for (int round = 0; round < 5000; ++round) {
    const InsideRule rule = kRules[round % 3];
    const int start = static_cast<int>(random.below(7)) - 3;
    std::vector<Crossing> crossings;
    std::map<LinePosition, int> change;
    const Index count = random.below(12);
    for (Index i = 0; i < count; ++i) {
      crossings.push_back({random.below(6), i, random.coin()});
      change[crossings.back().position] += crossings.back().leaving ? -1 : 1;
    }
    std::map<LinePosition, bool> expected;  // where the rule changes, and whether it is left
    std::map<LinePosition, int> after;
    int winding = start;
    for (const auto& [position, difference] : change) {
      const bool was = inside(rule, winding);
      winding += difference;
      after[position] = winding;
      if (was != inside(rule, winding)) expected[position] = was;
    }
    std::vector<ClassifiedCrossing> classified;
    ASSERT_EQ(classify_crossings(crossings, start, rule, classified), winding) << "the sum of all";
    ASSERT_EQ(classified.size(), count);
    std::map<LinePosition, bool> result;
    bool leaving = inside(rule, start);
    for (const ClassifiedCrossing& c : classified) {
      ASSERT_EQ(c.state_after(), after[c.position()]);
      if (!c.kept()) continue;
      ASSERT_TRUE(result.emplace(c.position(), c.leaving()).second) << "one a position";
      ASSERT_EQ(c.leaving(), leaving) << "kept hits alternate";
      leaving = !leaving;
    }
    ASSERT_EQ(result, expected) << "round " << round;
  }
}

}  // namespace
}  // namespace kdm
