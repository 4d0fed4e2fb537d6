// SPDX-License-Identifier: MIT
// Parts left out of results.
#include "extract/keep_parts.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "kdmanifold/build.h"
#include "support/mesh_check.h"
#include "support/shapes.h"

namespace kdm {
namespace {

// A ball of radius 3 with a cavity in which a small ball lies, and a middling box beside it.
Mesh scene() {
  return shapes::merged({shapes::icosphere(3, 3), shapes::inverted(shapes::icosphere(3, 2)),
                         shapes::icosphere(2, 1), shapes::box(Vec3(4, -1, -1), Vec3(6, 1, 1))});
}

double volume_of(Parts parts, Index& dropped) {
  const ExtractedMesh out =
      extract(build_grid(scene(), {.relative_tolerance = 0.001}), {.parts = parts});
  EXPECT_TRUE(check::check_mesh(out).two_manifold);
  EXPECT_EQ(describe(out).unreferenced_vertices, 0u);
  EXPECT_EQ(out.source_faces.size(), out.triangles.size());
  dropped = out.report.dropped_parts;
  return describe(out).volume;
}

TEST(KeepParts, OuterAndLargest) {
  const auto ball = [](int subdivisions, double radius) {
    return shapes::signed_volume(shapes::icosphere(subdivisions, radius));
  };
  Index dropped = 0;
  EXPECT_NEAR(volume_of(Parts::kAll, dropped), ball(3, 3) - ball(3, 2) + ball(2, 1) + 8, 0.8);
  EXPECT_EQ(dropped, 0u);
  EXPECT_NEAR(volume_of(Parts::kOuter, dropped), ball(3, 3) + 8, 0.8);
  EXPECT_EQ(dropped, 2u);
  EXPECT_NEAR(volume_of(Parts::kLargest, dropped), ball(3, 3), 0.8);
  EXPECT_EQ(dropped, 3u);
}

TEST(KeepParts, NormalsAndQuadsGoWithTheirFaces) {
  const Grid grid = build_grid(scene(), {.strategy = SplitStrategy::kUniform, .depth = 15});
  const ExtractedMesh out =
      extract(grid, {.quads = true, .parts = Parts::kLargest, .normals = true});
  ASSERT_EQ(out.corner_normals.size(), 3 * out.triangles.size() + 4 * out.quads.size());
  ASSERT_GT(out.quads.size(), 0u);
  // The largest is a ball about the origin: normals point where positions do.
  const auto check = [&](Index vertex, const std::array<float, 3>& normal) {
    const Vec3 n(normal[0], normal[1], normal[2]);
    EXPECT_GT(n.dot(out.positions[vertex].normalized()), 0.9);
  };
  std::size_t corner = 0;
  for (const Triangle& t : out.triangles) {
    for (const Index v : t) check(v, out.corner_normals[corner++]);
  }
  for (const Quad& q : out.quads) {
    for (const Index v : q) check(v, out.corner_normals[corner++]);
  }
}

// Only what was closed leaves crumbs; thin parts of the input stay.
TEST(KeepParts, CrumbsHaveAnInventedFace) {
  const Mesh plate = shapes::box(Vec3(0, 0, 0), Vec3(1, 1, 0.001));
  for (const bool invented : {false, true}) {
    Mesh mesh = shapes::merged({shapes::cube(), shapes::inverted(plate)});
    mesh.source_faces.assign(mesh.triangles.size(), 7);
    if (invented) mesh.source_faces.back() = kNone;
    mesh.source_faces[0] = kNone;  // the cube is no crumb, whatever it is made of
    const KeptParts kept = keep_parts(Parts::kAll, 0.01, mesh);
    EXPECT_EQ(kept.crumbs, invented ? 1u : 0u);
    EXPECT_EQ(mesh.triangles.size(), invented ? 12u : 24u);
    EXPECT_EQ(mesh.positions.size(), invented ? 8u : 16u);
    EXPECT_EQ(mesh.source_faces.size(), mesh.triangles.size());
    EXPECT_DOUBLE_EQ(kept.invented_area, 0.5);
  }
}

TEST(KeepParts, PartsThatAreMostlyInventedAreDropped) {
  Mesh mesh = shapes::merged({shapes::cube(), shapes::translated(shapes::cube(), Vec3(2, 0, 0))});
  mesh.source_faces.assign(mesh.triangles.size(), 7);
  for (std::size_t t = 0; t < 5; ++t) mesh.source_faces[t] = kNone;    // 5 of 7
  for (std::size_t t = 12; t < 18; ++t) mesh.source_faces[t] = kNone;  // 6 of 6
  Mesh kept = mesh;
  drop_invented_parts(1, kept);
  EXPECT_EQ(kept.triangles.size(), 24u);
  drop_invented_parts(0.8, kept);
  EXPECT_EQ(kept.triangles.size(), 12u);
  EXPECT_EQ(kept.source_faces.size(), 12u);
  EXPECT_EQ(std::count(kept.source_faces.begin(), kept.source_faces.end(), kNone), 5);
  drop_invented_parts(0.7, kept);
  EXPECT_TRUE(kept.triangles.empty());
}

}  // namespace
}  // namespace kdm
