// SPDX-License-Identifier: MIT
// Double edges of hand-made surfaces are taken apart; the judge looks at the result.
#include "extract/mend/double_edges.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <set>

#include "kdmanifold/build.h"
#include "kdmanifold/extract.h"
#include "support/dual_mesh_check.h"
#include "support/dual_mesh_shapes.h"
#include "support/mesh_assert.h"
#include "support/random_meshes.h"
#include "support/shapes.h"

namespace kdm {
namespace {

const GridData kNoGrid;

// Loops, arbitrary positions, and one point a hit.
std::vector<Vec3> prepare(DualMesh& mesh) {
  find_loops(kNoGrid, mesh);
  for (Index v = 0; v < mesh.vertices(); ++v) {
    mesh.position.emplace_back(v, v * v % 7, v * v * v % 11);
  }
  std::vector<Vec3> hit_points;
  for (Index t = 0; t < mesh.triangles(); ++t) hit_points.emplace_back(t, 100.0, -1.0 * t);
  return hit_points;
}

// A grid with a hit for each triangle. All hits lie in the plane y = 100, as their points do.
GridData grid_of(const DualMesh& mesh) {
  GridData grid;
  grid.planes.push_back({Vec3(0, 1, 0), 100});
  for (Index t = 0; t < mesh.triangles(); ++t) grid.hits.push_back(Hit(0, 0, false, false));
  return grid;
}

// How many edges there are beyond one between any two vertices.
Index surplus_edges(const DualMesh& mesh) {
  std::map<std::pair<Index, Index>, Index> uses;
  for (Index h = 0; h < mesh.vertex.size(); ++h) {
    ++uses[std::minmax(mesh.vertex[h], mesh.vertex[next_in_triangle(h)])];
  }
  Index surplus = 0;
  for (const auto& [edge, half_edges] : uses) surplus += half_edges / 2 - 1;
  return surplus;
}

TEST(DoubleEdges, ADoubleEdgeGetsOneVertex) {
  DualMesh mesh = shapes::beach_ball(2);
  const std::vector<Vec3> points = prepare(mesh);
  const GridData grid = grid_of(mesh);
  EditLog log;
  ASSERT_FALSE(check::is_two_manifold(shapes::index_mesh(mesh)));
  EXPECT_EQ(separate_double_edges({grid, {}, points}, mesh, log), 1u);
  check::expect_sound(mesh);
  const check::MeshCheck result = check::check_mesh(shapes::index_mesh(mesh));
  EXPECT_TRUE(result.two_manifold) << result.faults();
  EXPECT_EQ(result.euler_characteristic, 2);
  EXPECT_EQ(mesh.vertices(), 5u);
  EXPECT_EQ(mesh.triangles(), 6u);
  // The new vertex lies in the planes of the two hits whose triangles were divided, as near to the
  // middle of the edge as may be, and belongs to no leaf; the new triangles are of the same hits.
  EXPECT_EQ(mesh.leaf.back(), kNone);
  EXPECT_LT(mesh.hit[4], 4u);
  EXPECT_LT(mesh.hit[5], 4u);
  EXPECT_NE(mesh.hit[4], mesh.hit[5]);
  EXPECT_EQ(mesh.position.back()[1], 100);
  std::vector<Vec3> middles;
  for (const HalfEdgeId h : mesh.ring(mesh.vertices() - 1)) {
    const VertexId a = mesh.end_vertex(h);
    for (const HalfEdgeId g : mesh.ring(mesh.vertices() - 1)) {
      middles.push_back(0.5 * (mesh.position[a] + mesh.position[mesh.end_vertex(g)]));
    }
  }
  EXPECT_TRUE(std::any_of(middles.begin(), middles.end(), [&](const Vec3& m) {
    return m[0] == mesh.position.back()[0] && m[2] == mesh.position.back()[2];
  }));
}

TEST(DoubleEdges, MultipleEdgesKeepOne) {
  for (Index disks = 2; disks <= 9; ++disks) {
    DualMesh mesh = shapes::beach_ball(disks);
    const std::vector<Vec3> points = prepare(mesh);
    const GridData grid = grid_of(mesh);
    EditLog log;
    EXPECT_EQ(separate_double_edges({grid, {}, points}, mesh, log), disks - 1);
    check::expect_sound(mesh);
    const check::MeshCheck result = check::check_mesh(shapes::index_mesh(mesh));
    EXPECT_TRUE(result.two_manifold) << disks << ": " << result.faults();
    EXPECT_EQ(result.euler_characteristic, 2);
    EXPECT_EQ(result.components, 1);
  }
}

TEST(DoubleEdges, ARingOfManyNeighboursIsSearchedToo) {
  // More than a dozen neighbours, two of them the same.
  DualMesh mesh = shapes::beach_ball(20);
  const std::vector<Vec3> points = prepare(mesh);
  const GridData grid = grid_of(mesh);
  EditLog log;
  EXPECT_EQ(separate_double_edges({grid, {}, points}, mesh, log), 19u);
  EXPECT_TRUE(check::is_two_manifold(shapes::index_mesh(mesh)));
}

TEST(DoubleEdges, BothTrianglesMayHaveTheSameThirdVertex) {
  // Four vertices on a torus: edge 0-2 is doubled, and the triangles on both sides of it have
  // their third vertex in common, so the vertex put on it is doubly joined to that one in turn.
  DualMesh mesh = shapes::tight_torus(4, 2, 1);
  const std::vector<Vec3> points = prepare(mesh);
  const GridData grid = grid_of(mesh);
  EditLog log;
  bool found = false;
  for (Index h = 0; h < mesh.vertex.size(); ++h) {
    found |=
        mesh.vertex[previous_in_triangle(h)] == mesh.vertex[previous_in_triangle(mesh.opposite[h])];
  }
  ASSERT_TRUE(found);
  const Index inserted = separate_double_edges({grid, {}, points}, mesh, log);
  EXPECT_GE(inserted, 6u) << "twelve edges, but four vertices have six pairs only";
  check::expect_sound(mesh);
  EXPECT_EQ(surplus_edges(mesh), 0u);
  const check::MeshCheck result = check::check_mesh(shapes::index_mesh(mesh));
  EXPECT_TRUE(result.two_manifold) << result.faults();
  EXPECT_EQ(result.euler_characteristic, 0);
}

TEST(DoubleEdges, EveryTightTorusBecomesManifold) {
  int tested = 0;
  for (Index n = 3; n <= 12; ++n) {
    for (Index p = 1; p < n; ++p) {
      for (Index q = 1; q < n; ++q) {
        if ((p + q) % n == 0 || std::gcd(std::gcd(p, q), n) != 1) continue;
        SCOPED_TRACE(testing::Message() << n << ' ' << p << ' ' << q);
        DualMesh mesh = shapes::tight_torus(n, p, q);
        const std::vector<Vec3> points = prepare(mesh);
        const GridData grid = grid_of(mesh);
        EditLog log;
        ASSERT_EQ(mesh.vertices(), n);
        const Index surplus = surplus_edges(mesh);
        const Index inserted = separate_double_edges({grid, {}, points}, mesh, log);
        EXPECT_GE(inserted, surplus);
        EXPECT_EQ(mesh.vertices(), n + inserted);
        EXPECT_EQ(mesh.triangles(), 2 * n + 2 * inserted);
        check::expect_sound(mesh);
        const check::MeshCheck result = check::check_mesh(shapes::index_mesh(mesh));
        ASSERT_TRUE(result.two_manifold) << result.faults();
        EXPECT_EQ(result.euler_characteristic, 0);
        EXPECT_EQ(result.components, 1);
        for (Index t = 2 * n; t < mesh.triangles(); ++t) ASSERT_LT(mesh.hit[t], 2 * n);
        ++tested;
      }
    }
  }
  EXPECT_GT(tested, 300);
}

TEST(DoubleEdges, WhatIsManifoldStaysAsItIs) {
  for (DualMesh mesh :
       {shapes::dual_mesh(shapes::icosphere(1).triangles),
        shapes::dual_mesh(shapes::torus(1, 0.3, 6, 5).triangles), shapes::tight_torus(7, 1, 2)}) {
    const std::vector<Vec3> points = prepare(mesh);
    const GridData grid = grid_of(mesh);
    EditLog log;
    const DualMesh before = mesh;
    EXPECT_EQ(separate_double_edges({grid, {}, points}, mesh, log), 0u);
    EXPECT_EQ(mesh.vertex, before.vertex);
    EXPECT_EQ(mesh.opposite, before.opposite);
    EXPECT_EQ(mesh.hit, before.hit);
  }
}

TEST(DoubleEdges, AStripThatIsDividedIsNoLongerOne) {
  DualMesh mesh = shapes::beach_ball(2);
  const std::vector<Vec3> points = prepare(mesh);
  const GridData grid = grid_of(mesh);
  EditLog log;
  mesh.strip = {1, 1, 1, 1};  // both edges 0-1 cross strips
  separate_double_edges({grid, {}, points}, mesh, log);
  Index strips = 0;
  for (Index t = 0; t < mesh.triangles(); ++t) {
    for (Index i = 0; i < 3; ++i) {
      if ((mesh.strip[t] >> i & 1) == 0) continue;
      ++strips;
      const std::set<Index> ends{mesh.vertex[3 * t + i], mesh.vertex[next_in_triangle(3 * t + i)]};
      EXPECT_EQ(ends, (std::set<Index>{0, 1}));
      EXPECT_NE(mesh.strip[mesh.opposite[3 * t + i] / 3], 0);
    }
  }
  EXPECT_EQ(strips, 2u);
}

TEST(DoubleEdges, IsNeededAndReported) {
  // The raw surface of a thin wall on a coarse grid shows vertex pairs with several edges.
  Index inserted = 0;
  for (std::uint32_t seed = 0; seed < 10; ++seed) {
    const Grid grid = build_grid(shapes::random_voxels(4, 0.5, seed),
                                 {.strategy = SplitStrategy::kMedian, .depth = 10});
    // Vertex splits would take most of them apart.
    const ExtractedMesh raw =
        extract(grid, {.split_error = 1e9, .link_error = 1e9, .strict = Strict::kOff});
    const ExtractedMesh strict = extract(grid, {.split_error = 1e9, .link_error = 1e9});
    EXPECT_EQ(raw.report.inserted_vertices, 0u);
    ASSERT_TRUE(check::is_two_manifold(strict));
    if (strict.report.dropped_pillows == 0) {
      EXPECT_EQ(strict.positions.size(), raw.positions.size() + strict.report.inserted_vertices);
      EXPECT_EQ(strict.triangles.size(),
                raw.triangles.size() + 2 * strict.report.inserted_vertices);
    }
    EXPECT_EQ(check::is_two_manifold(raw),
              strict.report.inserted_vertices == 0 && strict.report.dropped_pillows == 0);
    inserted += strict.report.inserted_vertices;
  }
  EXPECT_GT(inserted, 0u);
}

}  // namespace
}  // namespace kdm
