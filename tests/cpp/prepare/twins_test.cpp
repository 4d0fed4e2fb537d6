// SPDX-License-Identifier: MIT
// Triangles over the same points are found among the few that their sides let be such.
#include "prepare/twins.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "support/random.h"
#include "support/shapes.h"

namespace kdm {
namespace {

std::vector<TriangleId> possible_twins(const std::vector<Triangle>& triangles, Index points) {
  return find_possible_twins(build_topology(triangles, points));
}

// Few points, so that many triangles have the same three, either way round.
TEST(Twins, AreAllFound) {
  check::Random random(3);
  std::size_t twins = 0;
  for (int run = 0; run < 500; ++run) {
    const Index points = 4 + random.below(4);
    std::vector<Triangle> triangles;
    std::map<std::set<Index>, std::vector<TriangleId>> same;
    for (std::size_t wanted = 2 + random.below(12); triangles.size() < wanted;) {
      const Triangle t = {random.below(points), random.below(points), random.below(points)};
      const std::set<Index> corners(t.begin(), t.end());
      if (corners.size() < 3) continue;
      same[corners].push_back(static_cast<TriangleId>(triangles.size()));
      triangles.push_back(t);
    }
    const std::vector<TriangleId> found = possible_twins(triangles, points);
    for (const auto& [corners, group] : same) {
      if (group.size() < 2) continue;
      twins += group.size();
      for (const TriangleId t : group) {
        EXPECT_TRUE(std::binary_search(found.begin(), found.end(), t));
      }
    }
  }
  EXPECT_GT(twins, 500u);
}

TEST(Twins, AreNoneWhereEverySideHasANeighbourOfItsOwn) {
  const Mesh torus = shapes::torus();
  EXPECT_TRUE(possible_twins(torus.triangles, static_cast<Index>(torus.positions.size())).empty());
  // A side without a neighbour does not make a twin.
  const Mesh open = shapes::open(torus);
  EXPECT_TRUE(possible_twins(open.triangles, static_cast<Index>(open.positions.size())).empty());
}

}  // namespace
}  // namespace kdm
