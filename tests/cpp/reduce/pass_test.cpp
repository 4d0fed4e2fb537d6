// SPDX-License-Identifier: MIT
#include "reduce/pass.h"

#include <gtest/gtest.h>

#include "kdmanifold/reduce.h"
#include "support/mesh_assert.h"
#include "support/shapes.h"

namespace kdm {
namespace {

// A thin shell, both sides of which come to meet where triangles get larger than it is thick.
Mesh thin_shell() {
  return shapes::merged({shapes::icosphere(4, 1), shapes::inverted(shapes::icosphere(4, 0.985))});
}

Workpiece unguarded(const Mesh& mesh) {
  return {HalfEdges(mesh.triangles, static_cast<Index>(mesh.positions.size())), mesh.positions,
          std::nullopt, Marks(mesh.positions.size())};
}

TEST(Pass, MarksWhereTrianglesCameToMeet) {
  const Mesh shell = thin_shell();
  Workpiece piece = unguarded(shell);
  const Pass pass = run_pass(piece, {4000, 80}, {});
  ASSERT_EQ(pass.levels.size(), 2u);
  EXPECT_EQ(find_self_intersections(pass.levels[0].mesh).pairs, 0u);
  const SelfIntersections meeting = find_self_intersections(pass.levels[1].mesh);
  ASSERT_GT(meeting.pairs, 0u);
  Marks corners(shell.positions.size());
  for (const Index face : meeting.faces) {
    for (const Index corner : pass.levels[1].mesh.triangles[face]) {
      corners.set(pass.levels[1].vertices[corner]);
    }
  }
  const Marks marked = vertices_that_meet(piece, pass.levels);
  for (VertexId v = 0; v < marked.size(); ++v) {
    VertexId end = v;
    while (piece.joined_to[end] != kNone) end = piece.joined_to[end];
    EXPECT_EQ(marked.test(v), corners.test(end)) << v;
  }
  EXPECT_FALSE(vertices_that_meet(piece, {pass.levels[0]}).any());
}

// What the tests ask of triangles is kept, and must be what a look at the mesh says.
TEST(Pass, KnowsTheTrianglesThatItLeaves) {
  const Mesh sphere = shapes::icosphere(3, 1);
  Workpiece piece = unguarded(sphere);
  run_pass(piece, {200}, {});
  Index left = 0;
  for (TriangleId t = 0; t < piece.mesh.triangles(); ++t) {
    if (piece.mesh.is_removed(t)) continue;
    const Triangle c = piece.mesh.corners(t);
    const FaceShape now =
        face_shape(piece.positions[c[0]], piece.positions[c[1]], piece.positions[c[2]]);
    EXPECT_EQ(piece.faces[t].normal, now.normal);
    EXPECT_EQ(piece.faces[t].doubled_area, now.doubled_area);
    EXPECT_EQ(piece.faces[t].shape, now.shape);
    ++left;
  }
  EXPECT_EQ(left, 200u);
}

TEST(Pass, IsRepeatedUntilNothingMeets) {
  const Mesh shell = thin_shell();
  const ReducedMesh few = reduce(shell, shell, {.target_triangles = {4000, 80}});
  for (const Mesh& level : few.levels) {
    EXPECT_TRUE(check::is_two_manifold(level));
    EXPECT_EQ(find_self_intersections(level).pairs, 0u);
    EXPECT_EQ(check::check_mesh(level).components, 2);
  }
  EXPECT_LE(few.levels[0].triangles.size(), 4000u);
}

}  // namespace
}  // namespace kdm
