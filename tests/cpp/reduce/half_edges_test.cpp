// SPDX-License-Identifier: MIT
#include "reduce/half_edges.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "kdmanifold/error.h"
#include "support/mesh_check.h"
#include "support/random.h"
#include "support/shapes.h"
#include "support/sheets.h"

namespace kdm {
namespace {

HalfEdges half_edges(const Mesh& mesh) {
  return HalfEdges(mesh.triangles, static_cast<Index>(mesh.positions.size()));
}

Mesh mesh_of(const HalfEdges& from, const std::vector<Vec3>& positions) {
  Mesh mesh;
  mesh.positions = positions;
  for (TriangleId t = 0; t < from.triangles(); ++t) {
    if (!from.is_removed(t)) mesh.triangles.push_back(from.corners(t));
  }
  return mesh;
}

std::set<VertexId> neighbours(const HalfEdges& mesh, VertexId v) {
  std::set<VertexId> found;
  mesh.for_each_neighbour(v, [&](VertexId w) { found.insert(w); });
  return found;
}

// Says whether the edge meets the link condition, by sets.
bool may_collapse(const HalfEdges& mesh, SideId h) {
  const VertexId a = mesh.start(h);
  const VertexId b = mesh.end(h);
  const bool edge_on_boundary = mesh.opposite(h) == kNone;
  if (!edge_on_boundary && mesh.on_boundary(a) && mesh.on_boundary(b)) return false;
  const std::set<VertexId> of_a = neighbours(mesh, a);
  const std::set<VertexId> of_b = neighbours(mesh, b);
  std::vector<VertexId> common;
  std::set_intersection(of_a.begin(), of_a.end(), of_b.begin(), of_b.end(),
                        std::back_inserter(common));
  if (common.size() != (edge_on_boundary ? 1u : 2u)) return false;
  if (mesh.living_triangles() <= 4) return false;
  // A tip of two triangles would be left with none, or one of three in a tetrahedron.
  for (const SideId side : {h, mesh.opposite(h)}) {
    if (side == kNone) continue;
    const VertexId tip = mesh.start(previous_side(side));
    if (neighbours(mesh, tip).size() <= (mesh.on_boundary(tip) ? 2u : 3u)) return false;
  }
  return true;
}

// Every walk round a vertex meets all its triangles, and opposites are each other's.
void expect_sound(const HalfEdges& mesh) {
  std::vector<Index> corners(mesh.vertices(), 0);
  for (TriangleId t = 0; t < mesh.triangles(); ++t) {
    if (mesh.is_removed(t)) continue;
    for (SideId h = 3 * t; h < 3 * t + 3; ++h) {
      ++corners[mesh.start(h)];
      const SideId back = mesh.opposite(h);
      if (back == kNone) continue;
      ASSERT_EQ(mesh.opposite(back), h);
      ASSERT_EQ(mesh.start(back), mesh.end(h));
      ASSERT_EQ(mesh.end(back), mesh.start(h));
    }
  }
  for (VertexId v = 0; v < mesh.vertices(); ++v) {
    if (mesh.leaving(v) == kNone) {
      ASSERT_EQ(corners[v], 0u) << "vertex " << v;
      continue;
    }
    Index met = 0;
    mesh.for_each_leaving(v, [&](SideId h) {
      ASSERT_EQ(mesh.start(h), v);
      ++met;
    });
    ASSERT_EQ(met, corners[v]) << "vertex " << v;
  }
}

TEST(HalfEdges, CollapsesKeepTopologyOfSolids) {
  const Mesh torus = shapes::torus(1, 0.3, 16, 8);
  HalfEdges mesh = half_edges(torus);
  check::Random random(1);
  Index collapses = 0;
  for (int i = 0; i < 3000; ++i) {
    const SideId h = random.below(3 * mesh.triangles());
    if (mesh.is_removed(triangle_of(h)) || !may_collapse(mesh, h)) continue;
    const Index before = mesh.living_triangles();
    mesh.collapse(h);
    ASSERT_EQ(mesh.living_triangles(), before - 2);
    ASSERT_NO_FATAL_FAILURE(expect_sound(mesh));
    ++collapses;
  }
  EXPECT_GT(collapses, 60u);
  const check::MeshCheck result = check::check_mesh(mesh_of(mesh, torus.positions));
  EXPECT_TRUE(result.two_manifold) << result.faults();
  EXPECT_EQ(result.euler_characteristic, 0);
}

TEST(HalfEdges, CollapsesKeepTopologyOfSheets) {
  const Mesh sheet = shapes::open(shapes::uv_sphere(12, 8), 30);
  const check::MeshCheck before = check::check_mesh(sheet);
  HalfEdges mesh = half_edges(sheet);
  check::Random random(2);
  Index on_rim = 0;
  for (int i = 0; i < 3000; ++i) {
    const SideId h = random.below(3 * mesh.triangles());
    if (mesh.is_removed(triangle_of(h)) || !may_collapse(mesh, h)) continue;
    on_rim += mesh.opposite(h) == kNone ? 1 : 0;
    mesh.collapse(h);
    ASSERT_NO_FATAL_FAILURE(expect_sound(mesh));
  }
  EXPECT_GT(on_rim, 3u);
  const check::MeshCheck after = check::check_mesh(mesh_of(mesh, sheet.positions));
  EXPECT_EQ(after.non_manifold_edges + after.non_manifold_vertices + after.misoriented_edges, 0);
  EXPECT_EQ(after.euler_characteristic, before.euler_characteristic);
  EXPECT_EQ(after.boundary_loops, before.boundary_loops);
}

TEST(HalfEdges, FlipsTurnEdgesAndBackAgain) {
  const Mesh sphere = shapes::icosphere(2);
  HalfEdges mesh = half_edges(sphere);
  check::Random random(3);
  Index flips = 0;
  for (int i = 0; i < 500; ++i) {
    const SideId h = random.below(3 * mesh.triangles());
    const VertexId c = mesh.start(previous_side(h));
    const VertexId d = mesh.start(previous_side(mesh.opposite(h)));
    if (neighbours(mesh, c).contains(d)) continue;
    // Neither end may be left with fewer than three neighbours.
    if (neighbours(mesh, mesh.start(h)).size() <= 3 || neighbours(mesh, mesh.end(h)).size() <= 3) {
      continue;
    }
    mesh.flip(h);
    ++flips;
    ASSERT_TRUE(neighbours(mesh, c).contains(d));
    ASSERT_NO_FATAL_FAILURE(expect_sound(mesh));
  }
  EXPECT_GT(flips, 100u);
  const check::MeshCheck result = check::check_mesh(mesh_of(mesh, sphere.positions));
  EXPECT_TRUE(result.two_manifold) << result.faults();
  EXPECT_EQ(result.euler_characteristic, 2);
}

TEST(HalfEdges, RefusesWhatIsNotManifold) {
  const auto message = [](const Mesh& mesh) -> std::string {
    try {
      half_edges(mesh);
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::kInvalidMesh);
      return error.what();
    }
    return "";
  };
  EXPECT_NE(message(shapes::cubes_at_edge()).find("more than two triangles"), std::string::npos);
  EXPECT_NE(message(shapes::cubes_at_vertex()).find("do not form one fan"), std::string::npos);
  EXPECT_EQ(message(shapes::cube()), "");
}

}  // namespace
}  // namespace kdm
