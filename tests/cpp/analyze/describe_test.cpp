// SPDX-License-Identifier: MIT
// `describe` and the tests' own judge, each against known answers and against each other.
#include "kdmanifold/mesh.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "kdmanifold/error.h"
#include "support/mesh_assert.h"
#include "support/mesh_check.h"
#include "support/random_meshes.h"
#include "support/shapes.h"

namespace kdm {
namespace {

using check::check_mesh;
using check::is_two_manifold;
using check::MeshCheck;

//      3
//     /|\        Counter-clockwise seen from outside.
//    0-+-2
//     \|/
//      1
Mesh tetrahedron_mesh() {
  return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
          {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}},
          {},
          {},
          {}};
}

// A second tetrahedron mirrored at the corner 0 or the edge 0-1, whose vertices it shares.
Mesh two_tetrahedra(int shared) {
  Mesh mesh = tetrahedron_mesh();
  const Index first = 4;
  std::array<Index, 4> v = {0, 0, 0, 0};
  if (shared < 2) {
    mesh.positions.push_back({-1, 0, 0});
    v[1] = first;
  } else {
    v[1] = 1;
  }
  v[2] = static_cast<Index>(mesh.positions.size());
  v[3] = v[2] + 1;
  mesh.positions.push_back({0, -1, 0});
  mesh.positions.push_back({0, 0, -1});
  // The point reflection turns the faces over, the half turn about the edge does not.
  const bool turned = shared < 2;
  for (Triangle t : tetrahedron_mesh().triangles) {
    Triangle u = {v[t[0]], v[t[1]], v[t[2]]};
    if (turned) std::swap(u[0], u[1]);
    mesh.triangles.push_back(u);
  }
  return mesh;
}

Mesh quad_cube() {
  return {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}},
          {},
          {{3, 2, 1, 0}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}},
          {},
          {}};
}

// A ring of n * m quads, as a torus is: every vertex has four.
Mesh quad_torus(Index n, Index m) {
  Mesh mesh;
  for (Index i = 0; i < n; ++i) {
    for (Index j = 0; j < m; ++j) {
      const double a = 2 * 3.14159265358979 * i / n;
      const double b = 2 * 3.14159265358979 * j / m;
      mesh.positions.push_back(
          {(3 + std::cos(b)) * std::cos(a), (3 + std::cos(b)) * std::sin(a), std::sin(b)});
      const Index i2 = (i + 1) % n, j2 = (j + 1) % m;
      mesh.quads.push_back({i * m + j, i2 * m + j, i2 * m + j2, i * m + j2});
    }
  }
  return mesh;
}

void expect_same_report(const Mesh& mesh, const std::string& name) {
  SCOPED_TRACE(name);
  const MeshReport report = describe(mesh);
  const MeshCheck judge = check_mesh(mesh);
  EXPECT_EQ(static_cast<int>(report.boundary_edges), judge.boundary_edges);
  EXPECT_EQ(static_cast<int>(report.non_manifold_edges), judge.non_manifold_edges);
  EXPECT_EQ(static_cast<int>(report.misoriented_edges), judge.misoriented_edges);
  EXPECT_EQ(static_cast<int>(report.non_manifold_vertices), judge.non_manifold_vertices);
  EXPECT_EQ(static_cast<int>(report.degenerate_faces), judge.degenerate_faces);
  EXPECT_EQ(static_cast<int>(report.duplicate_faces), judge.duplicate_faces);
  EXPECT_EQ(static_cast<int>(report.components), judge.components);
  EXPECT_EQ(report.euler_characteristic, judge.euler_characteristic);
  EXPECT_EQ(report.closed, judge.closed);
  EXPECT_EQ(report.two_manifold, judge.two_manifold);
  if (judge.closed && judge.oriented && judge.degenerate_faces == 0) {
    EXPECT_NEAR(report.volume, judge.volume, 1e-9 * (1 + std::abs(judge.volume)));
  }
}

TEST(Describe, Tetrahedron) {
  const Mesh mesh = tetrahedron_mesh();
  const MeshReport report = describe(mesh);
  EXPECT_EQ(report.vertices, 4u);
  EXPECT_EQ(report.triangles, 4u);
  EXPECT_EQ(report.quads, 0u);
  EXPECT_EQ(report.unreferenced_vertices, 0u);
  EXPECT_EQ(report.components, 1u);
  EXPECT_EQ(report.euler_characteristic, 2);
  EXPECT_TRUE(report.closed);
  EXPECT_TRUE(report.two_manifold);
  EXPECT_DOUBLE_EQ(report.volume, 1.0 / 6);
  EXPECT_DOUBLE_EQ(report.area, 1.5 + std::sqrt(3.0) / 2);
  EXPECT_EQ(report.bounds.min, Vec3(0, 0, 0));
  EXPECT_EQ(report.bounds.max, Vec3(1, 1, 1));
  EXPECT_TRUE(is_two_manifold(mesh));
  expect_same_report(mesh, "tetrahedron");
}

TEST(Describe, EmptyMeshIsNotClosed) {
  const MeshReport report = describe({});
  EXPECT_FALSE(report.closed);
  EXPECT_FALSE(report.two_manifold);
  EXPECT_GT(report.bounds.min.x(), report.bounds.max.x());
  EXPECT_EQ(report.euler_characteristic, 0);
  EXPECT_FALSE(is_two_manifold(Mesh{}));
  Mesh points;
  points.positions = {{1, 2, 3}};
  EXPECT_EQ(describe(points).unreferenced_vertices, 1u);
  expect_same_report({}, "empty");
}

TEST(Describe, QuadsAndTrianglesTogether) {
  Mesh mesh = quad_cube();
  expect_same_report(mesh, "quads");
  EXPECT_TRUE(describe(mesh).two_manifold);
  EXPECT_DOUBLE_EQ(describe(mesh).volume, 1);
  EXPECT_DOUBLE_EQ(describe(mesh).area, 6);
  mesh.triangles = {{3, 2, 1}, {3, 1, 0}};
  mesh.quads.erase(mesh.quads.begin());
  EXPECT_TRUE(describe(mesh).two_manifold);
  EXPECT_EQ(describe(mesh).euler_characteristic, 2);
  EXPECT_DOUBLE_EQ(describe(mesh).volume, 1);
  expect_same_report(mesh, "quads and triangles");
}

TEST(Describe, SharedVertex) {
  const Mesh mesh = two_tetrahedra(1);
  const MeshReport report = describe(mesh);
  EXPECT_TRUE(report.closed);
  EXPECT_EQ(report.non_manifold_vertices, 1u);
  EXPECT_EQ(report.non_manifold_edges, 0u);
  EXPECT_EQ(report.components, 2u);
  EXPECT_FALSE(report.two_manifold);
  EXPECT_EQ(check_mesh(mesh).faults(), "1 non-manifold vertices");
  expect_same_report(mesh, "shared vertex");
}

TEST(Describe, SharedEdge) {
  const Mesh mesh = two_tetrahedra(2);
  const MeshReport report = describe(mesh);
  EXPECT_TRUE(report.closed);
  EXPECT_EQ(report.non_manifold_edges, 1u);
  EXPECT_EQ(report.non_manifold_vertices, 2u);
  EXPECT_EQ(report.misoriented_edges, 0u);
  EXPECT_EQ(report.components, 1u);
  EXPECT_FALSE(report.two_manifold);
  EXPECT_TRUE(check_mesh(mesh).oriented);
  expect_same_report(mesh, "shared edge");
}

TEST(Describe, FlippedFace) {
  Mesh mesh = tetrahedron_mesh();
  std::swap(mesh.triangles[1][0], mesh.triangles[1][1]);
  EXPECT_EQ(describe(mesh).misoriented_edges, 3u);
  EXPECT_TRUE(describe(mesh).closed);
  EXPECT_FALSE(describe(mesh).two_manifold);
  EXPECT_FALSE(check_mesh(mesh).oriented);
  EXPECT_FALSE(is_two_manifold(mesh));
  expect_same_report(mesh, "flipped");
}

TEST(Describe, Hole) {
  Mesh mesh = tetrahedron_mesh();
  mesh.triangles.pop_back();
  EXPECT_EQ(describe(mesh).boundary_edges, 3u);
  EXPECT_EQ(describe(mesh).boundary_loops, 1u);
  EXPECT_EQ(describe(mesh).non_manifold_vertices, 0u);
  EXPECT_FALSE(describe(mesh).closed);
  EXPECT_EQ(describe(mesh).euler_characteristic, 1);
  expect_same_report(mesh, "hole");
  // Two faces that touch in the middle of an open fan: the vertex has two fans.
  const Mesh bow = {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {-1, 0, 0}, {-1, -1, 0}},
                    {{0, 1, 2}, {0, 3, 4}},
                    {},
                    {},
                    {}};
  EXPECT_EQ(describe(bow).non_manifold_vertices, 1u);
  EXPECT_EQ(describe(bow).boundary_loops, 2u) << "which touch";
  expect_same_report(bow, "bow tie");
}

TEST(Describe, DuplicateAndDegenerateFaces) {
  Mesh mesh = tetrahedron_mesh();
  mesh.triangles.push_back({1, 3, 0});  // the second face, begun elsewhere
  EXPECT_EQ(describe(mesh).duplicate_faces, 1u);
  EXPECT_EQ(describe(mesh).non_manifold_edges, 3u);
  EXPECT_FALSE(describe(mesh).two_manifold);
  expect_same_report(mesh, "duplicate");

  mesh = tetrahedron_mesh();
  mesh.triangles.push_back({1, 1, 2});
  mesh.quads.push_back({0, 1, 2, 1});
  EXPECT_EQ(describe(mesh).degenerate_faces, 2u);
  EXPECT_EQ(describe(mesh).non_manifold_edges, 0u);
  EXPECT_EQ(describe(mesh).euler_characteristic, 2);
  EXPECT_FALSE(describe(mesh).two_manifold);
  expect_same_report(mesh, "degenerate");

  // Back to back: every edge has its two faces, yet there is nothing between them.
  const Mesh pillow = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 1}}, {}, {}, {}};
  EXPECT_TRUE(describe(pillow).closed);
  EXPECT_EQ(describe(pillow).duplicate_faces, 1u);
  EXPECT_FALSE(describe(pillow).two_manifold);
  expect_same_report(pillow, "pillow");
}

TEST(Describe, Torus) {
  const Mesh mesh = quad_torus(24, 16);
  EXPECT_EQ(describe(mesh).euler_characteristic, 0);
  EXPECT_TRUE(describe(mesh).two_manifold);
  EXPECT_TRUE(is_two_manifold(mesh));
  EXPECT_GT(describe(mesh).volume, 50);
  expect_same_report(mesh, "torus");
}

TEST(Describe, UnreferencedVerticesTakeNoPart) {
  Mesh mesh = tetrahedron_mesh();
  mesh.positions.push_back({100, 100, 100});
  EXPECT_EQ(describe(mesh).unreferenced_vertices, 1u);
  EXPECT_EQ(describe(mesh).euler_characteristic, 2);
  EXPECT_EQ(describe(mesh).bounds.max, Vec3(1, 1, 1));
  EXPECT_TRUE(describe(mesh).two_manifold);
}

TEST(Describe, VolumeFarFromTheOrigin) {
  const Mesh mesh = shapes::translated(shapes::cube(), {1e8, -1e8, 1e8});
  EXPECT_NEAR(describe(mesh).volume, 1, 1e-6);
  EXPECT_NEAR(describe(shapes::inverted(mesh)).volume, -1, 1e-6);
}

TEST(Describe, RefusesIndicesOutOfRange) {
  Mesh mesh = tetrahedron_mesh();
  mesh.triangles[2][1] = 4;
  try {
    describe(mesh);
    FAIL() << "not refused";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kInvalidMesh);
    EXPECT_STREQ(error.what(), "triangles[2] names vertex 4, but there are 4 vertices");
  }
  mesh = quad_cube();
  mesh.quads[3][3] = kNone;
  EXPECT_THROW(describe(mesh), Error);
  EXPECT_EQ(check_mesh(mesh).bad_indices, 1);
  EXPECT_FALSE(is_two_manifold(mesh));
}

TEST(Describe, TheJudgeSeesCoordinatesThatAreNotFinite) {
  Mesh mesh = tetrahedron_mesh();
  mesh.positions[2].y() = std::nan("");
  EXPECT_EQ(check_mesh(mesh).bad_positions, 1);
  EXPECT_FALSE(is_two_manifold(mesh));
}

TEST(Describe, AgreesWithTheJudgeOnAllShapes) {
  for (const shapes::NamedShape& shape : shapes::all_shapes()) {
    if (shape.mesh.triangles.size() > 1000) continue;  // the judge is slow
    expect_same_report(shape.mesh, shape.name);
    expect_same_report(shapes::open(shape.mesh, 3), shape.name + ", open");
    expect_same_report(shapes::soup(shape.mesh), shape.name + ", soup");
  }
}

TEST(Describe, AgreesWithTheJudgeOnRandomMeshes) {
  for (std::uint32_t seed = 1; seed <= 10; ++seed) {
    expect_same_report(shapes::integer_tetrahedra(20, 3, seed), "tetrahedra");
    expect_same_report(shapes::random_voxels(4, 0.5, seed), "voxels");
    expect_same_report(shapes::collapsed_polyhedron(3, seed), "polyhedron");
  }
}

}  // namespace
}  // namespace kdm
