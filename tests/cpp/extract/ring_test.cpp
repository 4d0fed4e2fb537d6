// SPDX-License-Identifier: MIT
// Walks round vertices: closed ones, ones that end at the boundary, and the shortest of both.
#include "extract/dual/ring.h"

#include <gtest/gtest.h>

#include <set>
#include <vector>

#include "extract/dual/dual_mesh.h"
#include "support/dual_mesh_shapes.h"
#include "support/shapes.h"

namespace kdm {
namespace {

std::vector<HalfEdgeId> visited(const Ring& ring) {
  std::vector<HalfEdgeId> half_edges;
  for (const HalfEdgeId h : ring) half_edges.push_back(h);
  return half_edges;
}

// A fan of triangles (0, i, i + 1) round vertex 0, open between the last and the first.
DualMesh open_fan(Index triangles) {
  DualMesh mesh;
  mesh.open = true;
  mesh.first_half_edge.assign(triangles + 2, kNone);
  for (Index t = 0; t < triangles; ++t) {
    const HalfEdgeId h = mesh.add_triangle(t, 0, t + 1, t + 2);
    if (t > 0) mesh.link(h, h - 1);
  }
  for (HalfEdgeId h = 0; h < mesh.vertex.size(); ++h) {
    mesh.set_first_half_edge(mesh.vertex[h], h);
  }
  return mesh;
}

TEST(Ring, RoundAVertexEachHalfEdgeThatStartsThereComesOnce) {
  DualMesh mesh = shapes::dual_mesh(shapes::icosphere(1).triangles);
  find_loops(GridData(), mesh);
  std::size_t sum = 0;
  for (VertexId v = 0; v < mesh.vertices(); ++v) {
    const std::vector<HalfEdgeId> half_edges = visited(mesh.ring(v));
    ASSERT_EQ(half_edges.front(), mesh.first_half_edge[v]);
    for (std::size_t i = 0; i < half_edges.size(); ++i) {
      ASSERT_EQ(mesh.vertex[half_edges[i]], v);
      ASSERT_EQ(half_edges[(i + 1) % half_edges.size()], mesh.next_in_ring(half_edges[i]));
    }
    ASSERT_EQ(std::set<HalfEdgeId>(half_edges.begin(), half_edges.end()).size(), half_edges.size());
    sum += half_edges.size();
  }
  EXPECT_EQ(sum, mesh.vertex.size());
}

TEST(Ring, ItMayBeginAtAnyOfItsHalfEdges) {
  DualMesh mesh = shapes::dual_mesh({{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}});
  find_loops(GridData(), mesh);
  const std::vector<HalfEdgeId> half_edges = visited(mesh.ring(0));
  ASSERT_EQ(half_edges.size(), 3u);
  EXPECT_EQ(visited(mesh.ring_from(half_edges[1])),
            (std::vector<HalfEdgeId>{half_edges[1], half_edges[2], half_edges[0]}));
}

TEST(Ring, OnTheBoundaryItGoesFromOneSideToTheOther) {
  const DualMesh mesh = open_fan(4);
  EXPECT_TRUE(mesh.on_boundary(0));
  const std::vector<HalfEdgeId> half_edges = visited(mesh.ring(0));
  EXPECT_EQ(half_edges, (std::vector<HalfEdgeId>{9, 6, 3, 0}));
  EXPECT_EQ(mesh.vertex[mesh.boundary_into(0)], 5u) << "from where no half-edge of the ring leads";
  EXPECT_EQ(visited(mesh.ring_from(6)), (std::vector<HalfEdgeId>{6, 3, 0})) << "what is behind 6";
  EXPECT_EQ(visited(mesh.ring(2)), (std::vector<HalfEdgeId>{2, 4}));
}

TEST(Ring, ASingleTriangleHasOneHalfEdgeAtEachCorner) {
  const DualMesh mesh = open_fan(1);
  for (VertexId v = 0; v < 3; ++v) {
    EXPECT_EQ(visited(mesh.ring(v)), (std::vector<HalfEdgeId>{v}));
  }
}

TEST(Ring, AHalfEdgeLinkedToItsPredecessorIsARingOfOne) {
  DualMesh mesh = open_fan(1);
  mesh.link(0, 2);  // the triangle is closed to a cone with its tip in vertex 0
  EXPECT_EQ(visited(mesh.ring_from(0)), (std::vector<HalfEdgeId>{0}));
}

TEST(Ring, OfADroppedVertexItIsEmpty) {
  DualMesh mesh = open_fan(2);
  mesh.first_half_edge[0] = kNone;
  EXPECT_TRUE(visited(mesh.ring(0)).empty());
}

}  // namespace
}  // namespace kdm
