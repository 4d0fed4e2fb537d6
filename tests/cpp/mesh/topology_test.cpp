// SPDX-License-Identifier: MIT
// Neighbours and counts of triangle meshes, against a plain recount.
#include "mesh/topology.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "mesh/boundary_loops.h"
#include "prepare/non_manifold_edges.h"
#include "support/random.h"
#include "support/shapes.h"

namespace kdm {
namespace {

Topology topology_of(const Mesh& mesh) {
  return build_topology(mesh.triangles, static_cast<Index>(mesh.positions.size()));
}

Index start_of(const std::vector<Triangle>& triangles, Index side) {
  return triangles[side / 3][side % 3];
}
Index end_of(const std::vector<Triangle>& triangles, Index side) {
  return triangles[side / 3][next_corner(static_cast<int>(side % 3))];
}

// Opposites are mutual and run along the same edge the other way.
void expect_mutual_opposites(const std::vector<Triangle>& triangles, const Topology& topology) {
  ASSERT_EQ(topology.opposite.size(), 3 * triangles.size());
  for (Index side = 0; side < topology.opposite.size(); ++side) {
    const SideId opposite = topology.opposite[side];
    if (opposite == kNone) continue;
    ASSERT_LT(opposite, topology.opposite.size());
    ASSERT_EQ(topology.opposite[opposite], side);
    ASSERT_EQ(start_of(triangles, opposite), end_of(triangles, side));
    ASSERT_EQ(end_of(triangles, opposite), start_of(triangles, side));
  }
}

TEST(Topology, ATetrahedronIsClosed) {
  const Mesh mesh = shapes::tetrahedron();
  const Topology topology = topology_of(mesh);
  EXPECT_TRUE(topology.closed());
  EXPECT_EQ(topology.boundary_edges, 0u);
  EXPECT_EQ(topology.non_manifold_edges, 0u);
  EXPECT_EQ(topology.components, 1u);
  EXPECT_EQ(topology.first_unbalanced, kNone);
  expect_mutual_opposites(mesh.triangles, topology);
  EXPECT_EQ(std::count(topology.opposite.begin(), topology.opposite.end(), kNone), 0);
}

TEST(Topology, AnOpenEdgeHasNoTwin) {
  //   3       Sides 0-1, 1-2, 2-3, 3-0 are open; 0-2 is shared.
  //   |\ .
  //   | 2
  //   0-1
  const std::vector<Triangle> two{{0, 1, 2}, {0, 2, 3}};
  const Topology topology = build_topology(two, 4);
  EXPECT_FALSE(topology.closed());
  EXPECT_EQ(topology.boundary_edges, 4u);
  EXPECT_EQ(topology.unbalanced_edges, 4u);
  EXPECT_EQ(topology.first_unbalanced, 0u);
  EXPECT_EQ(topology.components, 1u);
  EXPECT_EQ(topology.opposite, (std::vector<Index>{kNone, kNone, 3, 2, kNone, kNone}));
}

TEST(Topology, FacesThatDisagreeAreUnbalancedNotOpen) {
  const std::vector<Triangle> disagreeing{{0, 1, 2}, {0, 1, 3}};
  const Topology topology = build_topology(disagreeing, 4);
  EXPECT_EQ(topology.boundary_edges, 4u);
  EXPECT_EQ(topology.unbalanced_edges, 5u);
  EXPECT_EQ(topology.opposite[0], kNone);
  EXPECT_EQ(topology.opposite[3], kNone);
  EXPECT_EQ(topology.components, 1u);
}

TEST(Topology, FourFacesOnAnEdgeArePairedByDirection) {
  const Mesh mesh = shapes::cubes_at_edge();
  const Topology topology = topology_of(mesh);
  EXPECT_TRUE(topology.closed());
  EXPECT_EQ(topology.non_manifold_edges, 1u);
  EXPECT_EQ(topology.components, 1u);
  expect_mutual_opposites(mesh.triangles, topology);
  EXPECT_EQ(std::count(topology.opposite.begin(), topology.opposite.end(), kNone), 0);
}

TEST(Topology, PartsAreJoinedByEdgesNotByVertices) {
  EXPECT_EQ(topology_of(shapes::cubes_at_vertex()).components, 2u);
  EXPECT_EQ(topology_of(shapes::torus_chain(5)).components, 5u);
}

TEST(Topology, ASideWithoutLengthIsIgnored) {
  const std::vector<Triangle> folded{{0, 0, 1}, {0, 1, 2}, {2, 1, 0}};
  const Topology topology = build_topology(folded, 3);
  EXPECT_EQ(topology.opposite[0], kNone);
  EXPECT_TRUE(topology.closed());
  EXPECT_EQ(topology.components, 1u);
  expect_mutual_opposites(folded, topology);
}

TEST(Topology, UnusedPointsDoNotMatter) {
  const std::vector<Triangle> pillow{{7, 8, 9}, {9, 8, 7}};
  EXPECT_TRUE(build_topology(pillow, 20).closed());
  EXPECT_TRUE(build_topology({}, 0).closed());
  EXPECT_EQ(build_topology({}, 5).components, 0u);
}

TEST(Topology, BoundaryLoopsGoRoundEachHole) {
  const auto loops = [](const std::vector<Triangle>& triangles) {
    return find_rim_loops(build_topology(triangles, 20).opposite).size();
  };
  EXPECT_EQ(loops({}), 0u);
  EXPECT_EQ(loops({{0, 1, 2}}), 1u);
  EXPECT_EQ(loops({{0, 1, 2}, {2, 1, 0}}), 0u);
  EXPECT_EQ(loops({{0, 1, 2}, {0, 2, 3}}), 1u);
  EXPECT_EQ(loops({{0, 1, 2}, {0, 2, 3}, {0, 3, 1}}), 1u) << "round an inner vertex";
  EXPECT_EQ(loops({{0, 1, 2}, {0, 3, 4}}), 2u) << "a common vertex joins nothing";
  EXPECT_EQ(loops({{0, 1, 2}, {1, 0, 3}}), 1u);
  EXPECT_EQ(loops({{0, 1, 2}, {0, 1, 3}}), 2u) << "turned against each other";
  // A band of six triangles between 0 1 2 and 3 4 5 has two rims.
  EXPECT_EQ(loops({{0, 1, 3}, {1, 4, 3}, {1, 2, 4}, {2, 5, 4}, {2, 0, 5}, {0, 3, 5}}), 2u);
}

TEST(Topology, RandomTrianglesAreCountedRight) {
  check::Random random(1);
  for (int round = 0; round < 400; ++round) {
    const Index points = 3 + random.below(6);
    std::vector<Triangle> triangles(1 + random.below(12));
    for (Triangle& t : triangles) {
      t = {random.below(points), random.below(points), random.below(points)};
    }
    std::map<std::pair<Index, Index>, std::vector<Index>> sides_at;
    for (Index side = 0; side < 3 * triangles.size(); ++side) {
      const Index a = start_of(triangles, side);
      const Index b = end_of(triangles, side);
      if (a != b) sides_at[std::minmax(a, b)].push_back(side);
    }
    Index boundary = 0;
    Index non_manifold = 0;
    Index unbalanced = 0;
    Index paired = 0;
    Index first = kNone;
    std::vector<Index> part(triangles.size());
    for (Index t = 0; t < part.size(); ++t) part[t] = t;
    for (const auto& [edge, sides] : sides_at) {
      boundary += sides.size() == 1 ? 1 : 0;
      non_manifold += sides.size() > 2 ? 1 : 0;
      Index up = 0;
      for (const Index side : sides) {
        up += start_of(triangles, side) == edge.first ? 1 : 0;
        const Index from = part[side / 3];
        const Index to = part[sides[0] / 3];
        std::replace(part.begin(), part.end(), from, to);
      }
      const auto down = static_cast<Index>(sides.size() - up);
      paired += 2 * std::min(up, down);
      if (up == down) continue;
      ++unbalanced;
      first = std::min(first, *std::min_element(sides.begin(), sides.end()));
    }
    const Topology topology = build_topology(triangles, points);
    ASSERT_EQ(topology.boundary_edges, boundary);
    ASSERT_EQ(topology.non_manifold_edges, non_manifold);
    ASSERT_EQ(topology.unbalanced_edges, unbalanced);
    ASSERT_EQ(topology.first_unbalanced, first);
    ASSERT_EQ(topology.closed(), unbalanced == 0);
    ASSERT_EQ(topology.components, std::set<Index>(part.begin(), part.end()).size());
    DisjointSets joined = join_at_edges(triangles, points, topology);
    for (Index t = 0; t < part.size(); ++t) {
      for (Index other = 0; other < t; ++other) {
        ASSERT_EQ(joined.find(t) == joined.find(other), part[t] == part[other]);
      }
    }
    expect_mutual_opposites(triangles, topology);
    const auto open = std::count(topology.opposite.begin(), topology.opposite.end(), kNone);
    ASSERT_EQ(topology.opposite.size() - static_cast<std::size_t>(open), paired)
        << "as many sides are paired as can be";
  }
}

// Sides of one edge are compared each with each: not where these are thousands.
TEST(Topology, CrowdsAtOneEdgeKeepTheirPairs) {
  std::vector<Vec3> points{Vec3(0, 0, 0), Vec3(0, 0, 1)};
  std::vector<Triangle> triangles;
  for (Index i = 0; i < 40000; ++i) {
    points.emplace_back(1, i, 0);
    triangles.push_back(i % 2 == 0 ? Triangle{0, 1, i + 2} : Triangle{1, 0, i + 2});
  }
  Topology topology = build_topology(triangles, static_cast<Index>(points.size()));
  const std::vector<Index> before = topology.opposite;
  pair_straightest(triangles, points, topology);
  EXPECT_EQ(topology.opposite, before);
}

}  // namespace
}  // namespace kdm
