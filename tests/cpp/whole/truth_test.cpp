// SPDX-License-Identifier: MIT
// A share of the random solids of tests/truth against their exact account: nothing is lost in
// silence, nothing is said that is not so. `npm run truth` tries as many as one likes.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <iostream>
#include <string>
#include <vector>

#include "support/sanitized.h"
#include "truth/judge.h"

namespace kdm::truth {
namespace {

struct Share {
  std::string kind;
  std::uint32_t count;       ///< seeds from 1 on
  std::vector<Check> unmet;  ///< what does not hold yet for all solids of the kind
  bool topology = false;     ///< parts and characteristic are right, resolved or not
};

void PrintTo(const Share& share, std::ostream* out) { *out << share.kind; }

// Known failures are the last column, and it must shrink: who mends one takes it out.
const std::vector<Share> kShares = {
    {"sound", 500, {}},
    {"nested", 500, {}},
    {"inverted", 500, {}},
    {"open", 500, {}},
    // A vertex of one in 500 is two tolerances off.
    {"torn", 500, {kFar}},
    // Turned, one of many squares may become a sliver.
    {"doubled", 400, {kVolume}},
    // The corner of one notch in 200.
    {"coincident", 200, {kMissing}},
    // The crease of a union.
    {"overlapping", 150, {kMissing}},
    {"touching", 150, {}},
    // Contacts of many voxels in one place; one of 30 is seven tolerances off.
    {"voxels", 30, {kFar, kMissing}},
    {"spun", 200, {}},
    // What is thinner than the tolerance.
    {"thin", 60, {kMissing}},
    {"wire", 24, {}},
    {"expression", 250, {}, true},
};

class Truth : public testing::TestWithParam<Share> {};

TEST_P(Truth, NothingIsLostInSilenceOrClaimedInVain) {
  const Share& share = GetParam();
  const std::uint32_t count = check::kSanitized ? 1 + share.count / 40 : share.count;
  std::array<std::size_t, kChecks> found = {};
  int failures = 0;
  for (std::uint32_t seed = 1; seed <= count && failures < 3; ++seed) {
    const Verdict verdict = judge(make_solid(share.kind, seed));
    if (share.topology && !verdict.topology_right) {
      ++failures;
      ADD_FAILURE() << "topology; npm run truth -- --kind " << share.kind << " --seed " << seed
                    << '\n'
                    << verdict.words;
    }
    for (std::size_t check = 0; check < kChecks; ++check) {
      if (!verdict.failed[check]) continue;
      ++found[check];
      const bool known = std::count(share.unmet.begin(), share.unmet.end(), check) > 0;
      if (known) continue;
      ++failures;
      ADD_FAILURE() << check_name(check) << "; npm run truth -- --kind " << share.kind << " --seed "
                    << seed << '\n'
                    << verdict.words;
    }
  }
  for (const Check check : share.unmet) {
    std::cout << share.kind << ": " << check_name(check) << " not yet in " << found[check] << " of "
              << count << '\n';
  }
}

INSTANTIATE_TEST_SUITE_P(Kinds, Truth, testing::ValuesIn(kShares),
                         [](const auto& given) { return given.param.kind; });

// Bars a tenth as thick as the tolerance that touch along their whole length: one triangle after
// the other came to cross its neighbours, for hundreds of rounds, until there were 120,000.
TEST(TruthOfThinContacts, EndsWithoutCrossings) {
  if (check::kSanitized) GTEST_SKIP() << "about time";
  const Verdict verdict = judge(make_solid("thin", 149));
  for (const Check check : {kThrows, kFaulty, kVolume, kFalseClaim, kCrossing, kSilent, kAccount}) {
    EXPECT_FALSE(verdict.failed[check]) << check_name(check) << '\n' << verdict.words;
  }
  EXPECT_LT(verdict.triangles, 3000) << "times those of the input";
}

// A gap that was closed on an edge of a leaf made one loop of two pieces, whose vertex fitted
// neither; and triangles that meet a cell in one point spoke for all that they hang together with.
TEST(TruthOfExpressions, HoldsForSomeThatFailed) {
  for (const std::uint32_t seed : {296u, 656u}) {
    const Verdict verdict = judge(make_solid("expression", seed));
    EXPECT_TRUE(verdict.right()) << seed << '\n' << verdict.words;
  }
}

TEST(TruthShares, HaveEachKindOnce) {
  std::vector<std::string> named;
  for (const Share& share : kShares) named.push_back(share.kind);
  std::vector<std::string> all = kinds();
  std::sort(named.begin(), named.end());
  std::sort(all.begin(), all.end());
  EXPECT_EQ(named, all);
}

}  // namespace
}  // namespace kdm::truth
