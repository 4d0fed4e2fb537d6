// SPDX-License-Identifier: MIT
// Holes are simple rounds of sides without opposite.
#include "prepare/holes.h"

#include <gtest/gtest.h>

#include "mesh/sides.h"
#include "mesh/topology.h"
#include "support/shapes.h"

namespace kdm {
namespace {

std::vector<Hole> holes_of(const std::vector<Triangle>& triangles, Index points) {
  return find_holes(triangles, points, build_topology(triangles, points).opposite);
}

std::vector<Hole> holes_of(const Mesh& mesh) {
  return holes_of(mesh.triangles, static_cast<Index>(mesh.positions.size()));
}

TEST(Holes, AClosedSurfaceHasNone) { EXPECT_TRUE(holes_of(shapes::torus()).empty()); }

TEST(Holes, SidesFollowEachOther) {
  const Mesh mesh = shapes::open(shapes::cube(), 2);
  const std::vector<Hole> holes = holes_of(mesh);
  ASSERT_EQ(holes.size(), 1u);
  ASSERT_EQ(holes[0].sides.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i) {
    const SideId side = holes[0].sides[i];
    const SideId next = holes[0].sides[(i + 1) % 4];
    EXPECT_EQ(mesh.triangles[triangle_of(side)][next_corner(corner_of(side))],
              mesh.triangles[triangle_of(next)][corner_of(next)]);
  }
}

TEST(Holes, EachRoundIsAHole) {
  Mesh tube = shapes::cylinder(1, 2, 8);
  std::erase_if(tube.triangles, [&](const Triangle& t) {
    return tube.positions[t[0]].z() == tube.positions[t[1]].z() &&
           tube.positions[t[1]].z() == tube.positions[t[2]].z();
  });
  const std::vector<Hole> holes = holes_of(tube);
  ASSERT_EQ(holes.size(), 2u);
  EXPECT_EQ(holes[0].sides.size(), 8u);
  EXPECT_EQ(holes[1].sides.size(), 8u);
}

// Two triangles that share a point only: a round through both passes it twice.
TEST(Holes, ARoundIsCutWhereItMeetsItself) {
  const std::vector<Triangle> triangles = {{0, 1, 2}, {0, 3, 4}, {1, 0, 5}, {3, 0, 5}};
  for (const Hole& hole : holes_of(triangles, 6)) {
    std::vector<PointId> points;
    for (const SideId side : hole.sides) {
      points.push_back(triangles[triangle_of(side)][corner_of(side)]);
    }
    std::sort(points.begin(), points.end());
    EXPECT_EQ(std::unique(points.begin(), points.end()), points.end());
    EXPECT_GE(hole.sides.size(), 3u);
  }
}

// Sides that run against each other along one edge are no hole, though they have no opposites.
TEST(Holes, TwoSidesAlongOneEdgeCloseEachOther) {
  const std::vector<Triangle> triangles = {{0, 1, 2}, {1, 0, 2}};
  const std::vector<SideId> opposite(6, kNone);
  EXPECT_LE(find_holes(triangles, 3, opposite).size(), 2u);
  std::vector<SideId> but_one = build_topology(triangles, 3).opposite;
  but_one[but_one[0]] = kNone;
  but_one[0] = kNone;
  EXPECT_TRUE(find_holes(triangles, 3, but_one).empty());
}

}  // namespace
}  // namespace kdm
