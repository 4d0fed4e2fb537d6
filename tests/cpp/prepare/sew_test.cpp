// SPDX-License-Identifier: MIT
// Cracks are closed, openings and neighbours that only lie close are not.
#include "prepare/sew.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "mesh/topology.h"
#include "support/shapes.h"
#include "support/sheets.h"

namespace kdm {
namespace {

Topology topology_of(const std::vector<Triangle>& triangles, const std::vector<Vec3>& points) {
  return build_topology(triangles, static_cast<Index>(points.size()));
}

struct Sewn {
  Index edges;
  std::vector<Triangle> triangles;
  std::vector<Vec3> points;

  Topology topology() const { return topology_of(triangles, points); }
};

Sewn sewn(const Mesh& mesh, double distance) {
  Sewn result{0, mesh.triangles, mesh.positions};
  Topology kept = topology_of(mesh.triangles, mesh.positions);
  result.edges = sew_rims(distance, result.triangles, result.points, kept);
  EXPECT_EQ(kept.opposite, result.topology().opposite);
  return result;
}

void expect_untouched(const Mesh& mesh, double distance) {
  const Sewn result = sewn(mesh, distance);
  EXPECT_EQ(result.edges, 0u);
  EXPECT_EQ(result.triangles, mesh.triangles);
  EXPECT_EQ(result.points, mesh.positions);
}

double farthest_move(const Mesh& mesh, const Sewn& result) {
  double farthest = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (int i = 0; i < 3; ++i) {
      const Vec3 move =
          result.points[result.triangles[t][i]] - mesh.positions[mesh.triangles[t][i]];
      farthest = std::max(farthest, move.norm());
    }
  }
  return farthest;
}

TEST(Sew, TornTrianglesFindTheirNeighbours) {
  const Mesh intact = shapes::icosphere(3);
  const Mesh torn = shapes::jittered(shapes::soup(intact), 0.004, 5);
  const Sewn result = sewn(torn, 0.02);
  EXPECT_EQ(result.edges, 3 * intact.triangles.size() / 2);
  EXPECT_TRUE(result.topology().closed());
  EXPECT_EQ(result.topology().components, 1u);
  EXPECT_EQ(result.topology().non_manifold_edges, 0u);
  EXPECT_GT(farthest_move(torn, result), 0);
  EXPECT_LT(farthest_move(torn, result), 0.02);
}

TEST(Sew, WhereTheyRunTheSameWayAsWell) {
  Mesh torn = shapes::jittered(shapes::soup(shapes::icosphere(2)), 0.004, 6);
  for (std::size_t t = 0; t < torn.triangles.size(); t += 3) {
    std::swap(torn.triangles[t][0], torn.triangles[t][1]);
  }
  EXPECT_EQ(sewn(torn, 0.02).topology().boundary_edges, 0u);
}

TEST(Sew, ASlitWithCommonEndsIsClosed) {
  // Two triangles that share one corner; the other ends of the slit gape.
  Mesh mesh;
  mesh.positions = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(1, 0.01, 0), Vec3(0, -1, 0)};
  mesh.triangles = {{0, 3, 2}, {0, 4, 1}};
  const Sewn result = sewn(mesh, 0.02);
  EXPECT_EQ(result.edges, 1u);
  EXPECT_EQ(result.triangles, (std::vector<Triangle>{{0, 1, 2}, {0, 4, 1}}));
  EXPECT_EQ(result.points[1], Vec3(1, 0.005, 0));
  EXPECT_EQ(sewn(mesh, 0.009).edges, 0u);
}

TEST(Sew, OpeningsStayOpen) {
  expect_untouched(shapes::open(shapes::cube(), 2), 0.3);
  for (const shapes::OpenShape& shape : shapes::open_shapes()) {
    SCOPED_TRACE(shape.name);
    expect_untouched(shape.mesh, 1e-3);
  }
}

TEST(Sew, ClosedPartsStayApartHoweverClose) {
  const Mesh cube = shapes::cube();
  expect_untouched(shapes::merged({cube, shapes::translated(cube, Vec3(1.001, 0, 0))}), 0.1);
}

// Sides shorter than the distance do not shrink to points.
TEST(Sew, SmallTrianglesKeepTheirSize) {
  expect_untouched(shapes::grid_sheet(10, 10, [](double, double) { return 0; }), 1);
}

TEST(Sew, ThousandsInOnePlaceTakeNoTime) {
  Mesh mesh;
  for (Index i = 0; i < 20000; ++i) {
    const double x = 1e-9 * i;
    for (const Vec3& p : {Vec3(x, 0, 0), Vec3(x + 1, 0, 0), Vec3(x, 1, 0)}) {
      mesh.positions.push_back(p);
    }
    mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  const Sewn result = sewn(mesh, 0.01);
  EXPECT_EQ(result.triangles.size(), mesh.triangles.size());
  EXPECT_LT(farthest_move(mesh, result), 0.01);
}

double torn_distance_of(const Mesh& mesh, double most) {
  return torn_distance(most, mesh.triangles, mesh.positions,
                       topology_of(mesh.triangles, mesh.positions));
}

TEST(Sew, FindsHowFarASurfaceIsTorn) {
  const Mesh torn = shapes::jittered(shapes::soup(shapes::icosphere(3)), 0.01, 9);
  const double distance = torn_distance_of(torn, 0.1);
  EXPECT_GT(distance, 0.01);
  EXPECT_LT(distance, 0.05);
  EXPECT_EQ(torn_distance_of(torn, 0.02), 0.02);
  // Hardly any rim has a partner as near as that.
  EXPECT_EQ(torn_distance_of(torn, 0.001), 0);
}

TEST(Sew, WhatIsOpenIsNotTorn) {
  EXPECT_EQ(torn_distance_of(shapes::torus(), 1), 0);
  EXPECT_EQ(torn_distance_of(shapes::open(shapes::cube(), 2), 1), 0);
  // A band, whose rims lie near each other, and two sheets over each other.
  Mesh band = shapes::cylinder(1, 0.05, 32);
  std::erase_if(band.triangles, [&](const Triangle& t) {
    return band.positions[t[0]].z() == band.positions[t[1]].z() &&
           band.positions[t[1]].z() == band.positions[t[2]].z();
  });
  EXPECT_EQ(torn_distance_of(band, 1), 0);
  const Mesh sheet = shapes::grid_sheet(2, 2, [](double, double) { return 0; });
  EXPECT_EQ(
      torn_distance_of(shapes::merged({sheet, shapes::translated(sheet, Vec3(0, 0, 0.01))}), 1), 0);
}

}  // namespace
}  // namespace kdm
