// SPDX-License-Identifier: MIT
// The account of tests/truth on solids that one can think through, and that its judge sees what is
// wrong.
#include <gtest/gtest.h>

#include "truth/judge.h"
#include "truth/near.h"
#include "truth/parts.h"

namespace kdm::truth {
namespace {

using Topologies = std::set<Topology>;

Account account_of_voxels(const std::vector<Place>& filled, int n = 3, bool inverse = false) {
  Cells cells(even_lines(n));
  if (inverse) cells.fill({{0, 0, 0}, {n, n, n}});
  for (const Place& at : filled) cells.fill({at, {at[0] + 1, at[1] + 1, at[2] + 1}}, !inverse);
  check::Random random(1);
  return account_of(cells, random);
}

TEST(TruthAccount, KnowsSolidsWithoutContacts) {
  const Account one = account_of_voxels({{1, 1, 1}});
  EXPECT_EQ(one.topology.any_of, (Topologies{{1, 2}}));
  EXPECT_EQ(one.volume, 1);
  EXPECT_EQ(area_of(one.boundary), 6);
  EXPECT_NEAR(volume_of(one.boundary), 1, 1e-12);
  const Account apart = account_of_voxels({{0, 0, 0}, {2, 0, 0}});
  EXPECT_EQ(apart.topology.any_of, (Topologies{{2, 4}}));
  const Account beside = account_of_voxels({{0, 0, 0}, {1, 0, 0}});
  EXPECT_EQ(beside.topology.any_of, (Topologies{{1, 2}})) << "the wall between does not count";
  EXPECT_EQ(beside.volume, 2);
  const Account ring = account_of_voxels(
      {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {2, 2, 0}, {1, 2, 0}, {0, 2, 0}, {0, 1, 0}});
  EXPECT_EQ(ring.topology.any_of, (Topologies{{1, 0}}));
  const Account hollow = account_of_voxels({{1, 1, 1}}, 3, true);
  EXPECT_EQ(hollow.topology.any_of, (Topologies{{2, 4}})) << "the cavity has a surface of its own";
  EXPECT_EQ(hollow.volume, 26);
}

TEST(TruthAccount, TakesContactsEitherWay) {
  const Account edge = account_of_voxels({{0, 0, 0}, {1, 1, 0}});
  EXPECT_EQ(edge.contacts, 1);
  EXPECT_EQ(edge.topology.any_of, (Topologies{{1, 2}, {2, 4}}));
  const Account long_edge = account_of_voxels({{0, 0, 0}, {0, 0, 1}, {1, 1, 0}, {1, 1, 1}});
  EXPECT_EQ(long_edge.contacts, 1) << "one choice for an edge that goes on";
  EXPECT_EQ(long_edge.topology.any_of, (Topologies{{1, 2}, {2, 4}}));
  const Account vertex = account_of_voxels({{0, 0, 0}, {1, 1, 1}});
  EXPECT_EQ(vertex.contacts, 1);
  EXPECT_EQ(vertex.topology.any_of, (Topologies{{1, 2}, {2, 4}}));
  // Two voids that meet in an edge within a block: two cavities, or one.
  const Account voids = account_of_voxels({{1, 1, 1}, {2, 2, 1}}, 4, true);
  EXPECT_EQ(voids.topology.any_of, (Topologies{{2, 4}, {3, 6}}));
  // A ring of four that is closed by an edge: parted a ball, joined a ring.
  const Account closed = account_of_voxels(
      {{0, 0, 0}, {0, 1, 0}, {0, 2, 0}, {1, 2, 0}, {2, 2, 0}, {2, 1, 0}, {1, 0, 0}});
  EXPECT_EQ(closed.topology.any_of, (Topologies{{1, 0}, {1, 2}}));
  // Four voxels of eight, each at an edge of each other: with k edges joined as a tree parts grow
  // fewer; with all of them joined a ball is left.
  const Account four = account_of_voxels({{0, 0, 0}, {1, 1, 0}, {1, 0, 1}, {0, 1, 1}});
  EXPECT_EQ(four.contacts, 6);
  EXPECT_TRUE(four.topology.holds({4, 8}));
  EXPECT_TRUE(four.topology.holds({1, 2}));
  EXPECT_FALSE(four.topology.holds({5, 10}));
}

TEST(TruthAccount, BoundsWhatItCannotTryOut) {
  std::vector<Place> checkers;
  for (int i = 0; i < 27; i += 2) checkers.push_back({i % 3, i / 3 % 3, i / 9});
  const Account account = account_of_voxels(checkers);
  EXPECT_TRUE(account.topology.ranges);
  EXPECT_TRUE(account.topology.holds({14, 28})) << "all parted";
  EXPECT_FALSE(account.topology.holds({15, 30}));
  EXPECT_FALSE(account.topology.holds({0, 0}));
}

TEST(TruthNear, MeasuresToFacesSidesAndCorners) {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
  mesh.triangles = {{0, 1, 2}};
  Near near(mesh);
  EXPECT_DOUBLE_EQ(near.distance({1, 1, 2}), 2);
  EXPECT_DOUBLE_EQ(near.distance({2, -3, 0}), 3);
  EXPECT_DOUBLE_EQ(near.distance({-3, -4, 0}), 5);
  EXPECT_TRUE(near.within({1, 1, 2}, 2));
  EXPECT_FALSE(near.within({1, 1, 2.01}, 2));
}

// A sound solid with a wrong account is as good as a wrong result with a right one.
TEST(TruthJudge, SeesWhatIsWrong) {
  const Solid solid = make_solid("sound", 1);
  const Verdict right = judge(solid);
  ASSERT_TRUE(right.right()) << right.words;
  ASSERT_TRUE(right.topology_resolved);

  Solid bigger = solid;
  bigger.account.volume += 2 * solid.tolerance * area_of(solid.account.boundary);
  EXPECT_TRUE(judge(bigger).failed[kVolume]);
  EXPECT_TRUE(judge(bigger).failed[kSilent]);

  Solid other = solid;
  other.account.topology.any_of = {{2, 4}};
  EXPECT_TRUE(judge(other).failed[kFalseClaim]);

  Solid more = solid;
  const Vec3 beside = solid.account.boundary.positions[0] + Vec3::Constant(1000 * solid.tolerance);
  for (const Vec3& by : {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)}) {
    more.account.boundary.positions.push_back(beside + by);
  }
  const Index last = static_cast<Index>(more.account.boundary.positions.size());
  more.account.boundary.triangles.push_back({last - 3, last - 2, last - 1});
  EXPECT_TRUE(judge(more).failed[kMissing]);

  Solid less = solid;
  less.slack = -3 * solid.tolerance;
  EXPECT_TRUE(judge(less).failed[kFar]);

  Solid nothing = solid;
  nothing.account = Account{};
  EXPECT_TRUE(judge(nothing).failed[kVolume]);

  Solid sheet = solid;
  sheet.input.triangles.resize(1);
  EXPECT_TRUE(judge(sheet).failed[kThrows]);
}

TEST(TruthSolid, IsTheSameForTheSameSeed) {
  for (const std::string& kind : kinds()) {
    const Solid once = make_solid(kind, 5);
    const Solid again = make_solid(kind, 5);
    EXPECT_EQ(once.input.positions, again.input.positions);
    EXPECT_EQ(once.input.triangles, again.input.triangles);
    EXPECT_NEAR(volume_of(once.account.boundary), once.account.volume,
                1e-9 * area_of(once.account.boundary) * std::sqrt(area_of(once.account.boundary)))
        << kind;
  }
}

}  // namespace
}  // namespace kdm::truth
