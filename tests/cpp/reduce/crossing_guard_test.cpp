// SPDX-License-Identifier: MIT
#include "reduce/crossing_guard.h"

#include <gtest/gtest.h>

#include "kdmanifold/mesh.h"
#include "support/random.h"
#include "support/shapes.h"

namespace kdm {
namespace {

// The ring that collapses of the edge to a point would leave.
CollapseRing ring_of(const HalfEdges& mesh, const std::vector<Vec3>& positions, SideId edge,
                     const Vec3& point) {
  CollapseRing ring;
  ring.kept = mesh.start(edge);
  ring.removed = mesh.end(edge);
  ring.point = point;
  ring.gone = {triangle_of(edge), triangle_of(mesh.opposite(edge))};
  for (const VertexId v : {ring.kept, ring.removed}) {
    mesh.for_each_leaving(v, [&](SideId h) {
      const TriangleId t = triangle_of(h);
      if (t == ring.gone[0] || t == ring.gone[1]) return;
      const VertexId from = mesh.end(h);
      const VertexId to = mesh.start(previous_side(h));
      ring.triangles.push_back({t, from, to, kNone, positions[from], positions[to], positions[v]});
    });
  }
  return ring;
}

// What the mesh would be after the collapse.
Mesh collapsed(const Mesh& mesh, const CollapseRing& ring) {
  Mesh result;
  result.positions = mesh.positions;
  result.positions[ring.kept] = ring.point;
  for (TriangleId t = 0; t < mesh.triangles.size(); ++t) {
    if (t == ring.gone[0] || t == ring.gone[1]) continue;
    Triangle corners = mesh.triangles[t];
    for (VertexId& v : corners) v = v == ring.removed ? ring.kept : v;
    result.triangles.push_back(corners);
  }
  return result;
}

// The guard must say what a search through the whole mesh says. The shells are so near to each
// other that many steps make one poke through the other.
TEST(CrossingGuard, SaysWhatAWholeSearchSays) {
  const Mesh shells = shapes::merged({shapes::icosphere(2, 0.5), shapes::icosphere(2, 0.47)});
  HalfEdges mesh(shells.triangles, static_cast<Index>(shells.positions.size()));
  CrossingGuard guard(mesh, shells.positions);
  CrossingGuard::Scratch scratch(mesh);
  check::Random random(1);
  int meeting = 0;
  constexpr int kSteps = 300;
  for (int i = 0; i < kSteps; ++i) {
    const SideId edge = random.below(3 * mesh.triangles());
    Vec3 point = 0.5 * (shells.positions[mesh.start(edge)] + shells.positions[mesh.end(edge)]);
    for (int axis = 0; axis < 3; ++axis) point[axis] += random.between(-0.06, 0.06);
    const CollapseRing ring = ring_of(mesh, shells.positions, edge, point);
    const bool meet = find_self_intersections(collapsed(shells, ring)).pairs > 0;
    ASSERT_EQ(guard.would_meet(ring, scratch), meet) << "edge " << edge;
    meeting += meet ? 1 : 0;
  }
  EXPECT_GT(meeting, kSteps / 10);
  EXPECT_LT(meeting, kSteps * 9 / 10);
}

// Where all is simple round a ring, nothing that shares a vertex with it may meet it; where it
// folds over, that must not be said.
TEST(CrossingGuard, CallsSimpleOnlyWhatDoesNotMeetItsSurroundings) {
  const Mesh box = shapes::subdivided(shapes::subdivided(shapes::cube()));
  const HalfEdges mesh(box.triangles, static_cast<Index>(box.positions.size()));
  CrossingGuard guard(mesh, box.positions);
  CrossingGuard::Scratch scratch(mesh);
  check::Random random(2);
  int simple = 0;
  int meeting = 0;
  for (int i = 0; i < 800; ++i) {
    const SideId edge = random.below(3 * mesh.triangles());
    Vec3 point = 0.5 * (box.positions[mesh.start(edge)] + box.positions[mesh.end(edge)]);
    point += 0.25 * random.point(-1, 1);
    const CollapseRing ring = ring_of(mesh, box.positions, edge, point);
    // So small a step reaches no other part of the box: what meets shares vertices.
    const bool meet = find_self_intersections(collapsed(box, ring)).pairs > 0;
    const bool said = guard.is_simple_all_round(ring, scratch);
    ASSERT_FALSE(said && meet) << "edge " << edge;
    simple += said ? 1 : 0;
    meeting += meet ? 1 : 0;
  }
  EXPECT_GT(simple, 20);
  EXPECT_GT(meeting, 20);
}

// The last triangle shares a corner with each of the first two and leads from one to the other
// through both. From either its other corners lie beyond the side that these share.
TEST(CrossingGuard, SeesWhatLeadsThroughFromASharedCorner) {
  Mesh folded;
  folded.positions = {{-0.2777, 0.108, -0.0039},
                      {0.0038, -0.025, -0.0241},
                      {0.2002, -0.0511, -0.0299},
                      {0.0038, 0.0499, -0.0241},
                      {-0.0195, 0.0199, 0.0693}};
  folded.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {3, 4, 1}};
  for (const bool leads_through : {true, false}) {
    if (!leads_through) folded.positions[4].z() = -0.2;
    EXPECT_EQ(find_self_intersections(folded).pairs > 0, leads_through);
    HalfEdges mesh(folded.triangles, static_cast<Index>(folded.positions.size()));
    CrossingGuard guard(mesh, folded.positions);
    CrossingGuard::Scratch scratch(mesh);
    EXPECT_EQ(guard.would_meet({0, 1}, {mesh.corners(0), mesh.corners(1)}, scratch), leads_through);
  }
}

TEST(CrossingGuard, RefusesTrianglesWithoutArea) {
  const Mesh sphere = shapes::icosphere(1, 0.5);
  HalfEdges mesh(sphere.triangles, static_cast<Index>(sphere.positions.size()));
  CrossingGuard guard(mesh, sphere.positions);
  CrossingGuard::Scratch scratch(mesh);
  const CollapseRing ring = ring_of(mesh, sphere.positions, 0, sphere.positions[mesh.start(0)]);
  CollapseRing flat = ring;
  flat.point = ring.triangles.front().from_point;
  EXPECT_TRUE(guard.would_meet(flat, scratch));
}

TEST(CrossingGuard, KnowsWhatChanged) {
  Mesh cubes = shapes::merged({shapes::box(Vec3(0, 0, 0), Vec3(0.4, 0.4, 0.4)),
                               shapes::box(Vec3(0.5, 0, 0), Vec3(0.9, 0.4, 0.4))});
  HalfEdges mesh(cubes.triangles, static_cast<Index>(cubes.positions.size()));
  std::vector<Vec3> positions = cubes.positions;
  CrossingGuard guard(mesh, positions);
  CrossingGuard::Scratch scratch(mesh);
  // A vertex of the first cube moves into the second one: the guard sees it once it is told.
  const auto places = std::array<TriangleId, 2>{12, 13};
  const std::array<Triangle, 2> same = {mesh.corners(12), mesh.corners(13)};
  EXPECT_FALSE(guard.would_meet(places, same, scratch));
  for (VertexId v = 0; v < 8; ++v) {
    if (positions[v].x() > 0.3) positions[v].x() = 0.6;
  }
  for (TriangleId t = 0; t < 12; ++t) guard.changed(t);
  bool meet = false;
  for (TriangleId t = 12; t + 1 < 24; t += 2) {
    meet = meet || guard.would_meet({t, t + 1}, {mesh.corners(t), mesh.corners(t + 1)}, scratch);
  }
  EXPECT_TRUE(meet);
}

}  // namespace
}  // namespace kdm
