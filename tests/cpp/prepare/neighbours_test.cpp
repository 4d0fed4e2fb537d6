// SPDX-License-Identifier: MIT
// Neighbours that disagree: what is turned, what belongs together, what cannot be oriented.
#include "prepare/neighbours.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "mesh/topology.h"
#include "support/random.h"
#include "support/shapes.h"
#include "support/sheets.h"

namespace kdm {
namespace {

NeighbourDirections directions_of(const Mesh& mesh) {
  return orient_neighbours(
      mesh.triangles, mesh.positions,
      build_topology(mesh.triangles, static_cast<Index>(mesh.positions.size())));
}

// Turns each face with the given probability; `turned` tells which.
Mesh with_turned_faces(Mesh mesh, double share, std::uint32_t seed, Marks& turned) {
  check::Random random(seed);
  turned.assign(mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (random.unit() >= share) continue;
    turned.set(t);
    std::swap(mesh.triangles[t][1], mesh.triangles[t][2]);
  }
  return mesh;
}

Marks marks(std::initializer_list<bool> flags) {
  Marks result;
  for (const bool flag : flags) result.push_back(flag);
  return result;
}

std::vector<Triangle> turned_back(const Mesh& mesh, const Marks& must_turn) {
  std::vector<Triangle> triangles = mesh.triangles;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    if (must_turn.test(t)) std::swap(triangles[t][1], triangles[t][2]);
  }
  return triangles;
}

TEST(Neighbours, WhatIsClosedAndConsistentStaysAsItIs) {
  for (const shapes::NamedShape& shape : shapes::all_shapes()) {
    if (shape.name == "integer_tetrahedra") continue;  // some lie back to back, see below
    SCOPED_TRACE(shape.name);
    const NeighbourDirections result = directions_of(shape.mesh);
    EXPECT_EQ(result.must_turn.count(), 0u);
    EXPECT_EQ(result.contradictions, 0u);
    for (const PartDirection& part : result.parts) {
      EXPECT_TRUE(part.closed);
      EXPECT_TRUE(part.oriented);
      EXPECT_EQ(part.agreeing, part.area);
    }
  }
}

TEST(Neighbours, TurnedFacesOfAClosedShapeAreFound) {
  for (const double share : {0.01, 0.1, 0.3}) {
    Marks turned;
    const Mesh mesh = with_turned_faces(shapes::torus(), share, 7, turned);
    const NeighbourDirections result = directions_of(mesh);
    EXPECT_EQ(result.must_turn, turned) << share;
    ASSERT_EQ(result.parts.size(), 1u);
    EXPECT_TRUE(result.parts[0].closed);
    EXPECT_FALSE(result.parts[0].oriented);
    EXPECT_GT(result.parts[0].agreeing / result.parts[0].area, 0.9 - share);
    EXPECT_EQ(result.contradictions, 0u);
  }
}

TEST(Neighbours, TheLargerAreaDecides) {
  //  A small face before a large one.
  Mesh mesh;
  mesh.positions = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 0.1, 0), Vec3(0, -5, 0)};
  mesh.triangles = {{0, 1, 2}, {0, 1, 3}};
  EXPECT_EQ(directions_of(mesh).must_turn, marks({true, false}));
  mesh.positions[2] = Vec3(0, 9, 0);
  EXPECT_EQ(directions_of(mesh).must_turn, marks({false, true}));
  mesh.positions[2] = Vec3(0, 5, 0);  // a tie: the first stays
  EXPECT_EQ(directions_of(mesh).must_turn, marks({false, true}));
}

TEST(Neighbours, AMoebiusBandIsCutOnce) {
  const Mesh band = shapes::moebius_band(40);
  const NeighbourDirections plain = directions_of(band);
  EXPECT_EQ(plain.contradictions, 1u);
  EXPECT_EQ(plain.must_turn.count(), 0u) << "the seam it has is kept";
  ASSERT_EQ(plain.parts.size(), 1u);
  EXPECT_FALSE(plain.parts[0].closed);
  EXPECT_FALSE(plain.parts[0].oriented);
  EXPECT_FALSE(plain.parts[0].orientable);
  for (const std::uint32_t seed : {1u, 2u, 3u}) {
    Marks turned;
    const Mesh mixed = with_turned_faces(band, 0.3, seed, turned);
    const NeighbourDirections result = directions_of(mixed);
    EXPECT_EQ(result.contradictions, 1u);
    const Topology topology = build_topology(turned_back(mixed, result.must_turn),
                                             static_cast<Index>(band.positions.size()));
    EXPECT_EQ(topology.unbalanced_edges, topology.boundary_edges + 1);
  }
}

TEST(Neighbours, CopiesFollowTheFirst) {
  // Every face of a torus a second time, half of them the other way round.
  const Mesh torus = shapes::torus();
  Marks turned;
  Mesh doubled = with_turned_faces(torus, 0.5, 3, turned);
  const auto faces = static_cast<Index>(torus.triangles.size());
  doubled.triangles.insert(doubled.triangles.begin(), torus.triangles.begin(),
                           torus.triangles.end());
  const NeighbourDirections result = directions_of(doubled);
  ASSERT_EQ(result.parts.size(), 1u);
  EXPECT_TRUE(result.parts[0].closed);
  EXPECT_EQ(result.parts[0].triangles, 2 * faces);
  for (Index t = 0; t < faces; ++t) {
    EXPECT_EQ(result.copy_of[t], kNone);
    EXPECT_EQ(result.copy_of[faces + t], t);
    EXPECT_EQ(result.must_turn.test(faces + t), turned.test(t));
  }
}

TEST(Neighbours, FacesBackToBackAllOverAreOneSurface) {
  Mesh cube = shapes::cube();
  const std::vector<Triangle> back = shapes::inverted(cube).triangles;
  cube.triangles.insert(cube.triangles.end(), back.begin(), back.end());
  const NeighbourDirections result = directions_of(cube);
  ASSERT_EQ(result.parts.size(), 1u);
  EXPECT_TRUE(result.parts[0].closed);
  EXPECT_EQ(result.parts[0].area, 6);
  for (Index t = 0; t < 24; ++t) EXPECT_EQ(result.must_turn.test(t), t >= 12);
}

TEST(Neighbours, EdgesOfThreeJoinNothing) {
  //  Three rectangles that meet in the z axis.
  Mesh mesh;
  mesh.positions = {Vec3(0, 0, 0), Vec3(0, 0, 1)};
  for (const Vec3& end : {Vec3(1, 0, 0), Vec3(-1, 1, 0), Vec3(-1, -1, 0)}) {
    const auto i = static_cast<Index>(mesh.positions.size());
    mesh.positions.push_back(end);
    mesh.positions.emplace_back(end + Vec3(0, 0, 1));
    mesh.triangles.push_back({0, i, i + 1});
    mesh.triangles.push_back({0, i + 1, 1});
  }
  const NeighbourDirections result = directions_of(mesh);
  EXPECT_EQ(result.part, (std::vector<Index>{0, 0, 1, 1, 2, 2}));
  EXPECT_EQ(result.must_turn.count(), 0u);
  for (const PartDirection& part : result.parts) EXPECT_FALSE(part.closed);
}

TEST(Neighbours, SolidsThatShareAnEdgeAreTwoParts) {
  const NeighbourDirections result = directions_of(shapes::cubes_at_edge());
  ASSERT_EQ(result.parts.size(), 2u);
  EXPECT_TRUE(result.parts[0].closed);
  EXPECT_TRUE(result.parts[1].closed);
}

TEST(Neighbours, OneTriangleManyTimes) {
  Mesh mesh;
  mesh.positions = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)};
  for (int i = 0; i < 100000; ++i) mesh.triangles.push_back({0, 1, 2});
  mesh.triangles.push_back({1, 0, 2});
  const NeighbourDirections result = directions_of(mesh);
  ASSERT_EQ(result.parts.size(), 1u);
  EXPECT_EQ(result.parts[0].area, 0.5);
  EXPECT_EQ(result.must_turn.count(), 1u);
  EXPECT_TRUE(orient_neighbours({}, {}, {}).parts.empty());
}

}  // namespace
}  // namespace kdm
