// SPDX-License-Identifier: MIT
// Closed parts that are inside out are turned, one by one; cavities are not.
#include <gtest/gtest.h>

#include "kdmanifold/build.h"
#include "kdmanifold/extract.h"
#include "kdmanifold/grid_io.h"
#include "mesh/topology.h"
#include "prepare/inverted_parts.h"
#include "support/mesh_check.h"
#include "support/random_meshes.h"
#include "support/sanitized.h"
#include "support/shapes.h"

namespace kdm {
namespace {

Mesh box_at(double x, double size) {
  return shapes::box(Vec3(x, 0, 0), Vec3(x + size, size, size));
}

// A box round the middle of the space that `box_at(0, size)` takes for a size of 8.
Mesh box_within(double half) {
  return shapes::box(Vec3::Constant(4 - half), Vec3::Constant(4 + half));
}

InvertedParts inverted_parts_of(const Mesh& mesh) {
  const Topology topology =
      build_topology(mesh.triangles, static_cast<Index>(mesh.positions.size()));
  return find_inverted_parts(mesh.triangles, mesh.positions, topology);
}

struct Built {
  InputReport input;
  Mesh mesh;
  double volume = 0;
};

Built built(const Mesh& mesh, InsideRule rule = InsideRule::kRepair) {
  const Grid grid = build_grid(mesh, {.tolerance = 0.01, .inside = rule});
  Built result{grid.input(), extract(grid), 0};
  const check::MeshCheck report = check::check_mesh(result.mesh);
  EXPECT_TRUE(report.two_manifold) << report.faults();
  result.volume = report.volume;
  return result;
}

TEST(InvertedParts, NoneIsTurnedWhereAllLookOutwards) {
  for (const Mesh& mesh : {shapes::cube(), shapes::torus_chain(3), shapes::nested_shells(),
                           shapes::overlapping_cubes(), shapes::cubes_at_vertex()}) {
    const InvertedParts found = inverted_parts_of(mesh);
    EXPECT_EQ(found.parts, 0u);
    EXPECT_TRUE(found.must_turn.empty());
    EXPECT_TRUE(found.nesting_known);
  }
}

TEST(InvertedParts, OneOfTwoIsTurned) {
  const Mesh mesh = shapes::merged({box_at(0, 1), shapes::inverted(box_at(5, 2))});
  const InvertedParts found = inverted_parts_of(mesh);
  EXPECT_EQ(found.parts, 1u);
  EXPECT_FALSE(found.all);
  for (TriangleId t = 0; t < mesh.triangles.size(); ++t) {
    EXPECT_EQ(found.must_turn.test(t), t >= 12) << t;
  }
  const Built result = built(mesh);
  EXPECT_NEAR(result.volume, 9, 1e-6);
  EXPECT_EQ(result.input.turned_parts, 1u);
  EXPECT_EQ(result.input.turned_faces, 12u);
  EXPECT_FALSE(result.input.flipped);
  EXPECT_TRUE(result.input.closed);
}

TEST(InvertedParts, WhatOverlapsIsTurnedToo) {
  const Mesh mesh = shapes::merged(
      {shapes::cube(), shapes::inverted(shapes::translated(shapes::cube(), Vec3::Constant(0.5)))});
  EXPECT_NEAR(built(mesh).volume, 1.875, 1e-6);
}

TEST(InvertedParts, CavitiesStay) {
  const Mesh hollow = shapes::merged({box_within(4), shapes::inverted(box_within(2))});
  EXPECT_EQ(inverted_parts_of(hollow).parts, 0u);
  EXPECT_NEAR(built(hollow).volume, 512 - 64, 1e-6);
  // What lies in the cavity looks outwards.
  const Mesh filled = shapes::merged({hollow, shapes::inverted(box_within(1))});
  const Built result = built(filled);
  EXPECT_NEAR(result.volume, 512 - 64 + 8, 1e-6);
  EXPECT_EQ(result.input.turned_parts, 1u);
  // A part within what is solid stays, however it is turned.
  EXPECT_EQ(inverted_parts_of(shapes::merged({box_within(4), box_within(2)})).parts, 0u);
}

TEST(InvertedParts, WhatIsInsideOutAsAWholeKeepsItsCavities) {
  const Mesh hollow = shapes::merged({box_within(4), shapes::inverted(box_within(2))});
  const Mesh mesh = shapes::inverted(hollow);
  const InvertedParts found = inverted_parts_of(mesh);
  EXPECT_EQ(found.parts, 2u);
  EXPECT_TRUE(found.all);
  const Built result = built(mesh);
  EXPECT_NEAR(result.volume, 512 - 64, 1e-6);
  EXPECT_TRUE(result.input.flipped);
  EXPECT_EQ(result.input.turned_parts, 0u);
  // Beside another body it is a part of the whole that is turned along with its cavity.
  const Mesh beside = shapes::merged({box_at(20, 1), mesh});
  EXPECT_NEAR(built(beside).volume, 512 - 64 + 1, 1e-6);
  EXPECT_EQ(built(beside).input.turned_parts, 2u);
}

TEST(InvertedParts, WhatIsOpenOrFlatIsLeftAlone) {
  EXPECT_EQ(inverted_parts_of(shapes::inverted(shapes::open(shapes::cube()))).parts, 0u);
  Mesh pillow;
  pillow.positions = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)};
  pillow.triangles = {{0, 2, 1}, {0, 1, 2}};
  EXPECT_EQ(inverted_parts_of(pillow).parts, 0u);
}

// A cavity whose corners all lie on the outer surface.
TEST(InvertedParts, ACavityThatTouchesTheOutsideStays) {
  const Mesh mesh = shapes::voxels(3, 3, 3, [](int x, int y, int z) {
    const int middles = (x == 1 ? 1 : 0) + (y == 1 ? 1 : 0) + (z == 1 ? 1 : 0);
    return middles == 1 || middles == 2;
  });
  const Built result = built(mesh);
  EXPECT_EQ(result.input.turned_parts, 0u);
  EXPECT_NEAR(result.volume, 18, 0.1);
}

// A body with its backs, whose quads are cut along the other diagonals.
TEST(InvertedParts, BacksWithOtherTrianglesCountOnce) {
  Mesh front;
  Mesh back;
  front.positions = back.positions = shapes::cube().positions;
  const Mesh cube = shapes::cube();
  for (std::size_t i = 0; i < 12; i += 2) {
    // Two triangles that share an edge become one quad, and are cut the other way.
    const Triangle& a = cube.triangles[i];
    const Triangle& b = cube.triangles[i + 1];
    int apex = 0;
    while (std::find(b.begin(), b.end(), a[apex]) != b.end()) ++apex;
    int other = 0;
    while (std::find(a.begin(), a.end(), b[other]) != a.end()) ++other;
    const Index p = a[apex];
    const Index q = a[(apex + 1) % 3];
    const Index r = b[other];
    const Index s = a[(apex + 2) % 3];
    front.triangles.insert(front.triangles.end(), {{p, q, s}, {q, r, s}});
    back.triangles.insert(back.triangles.end(), {{p, r, q}, {p, s, r}});
  }
  const Built result = built(shapes::merged({front, back}));
  EXPECT_EQ(result.input.duplicate_faces, 12u);
  EXPECT_EQ(result.input.turned_parts, 0u);
  EXPECT_NEAR(result.volume, 1, 1e-6);
}

// A notch that is joined to its body along edges of four faces only, and reaches out of the part
// that it is taken off: a piece of the surface, though its volume is negative.
TEST(InvertedParts, ANotchStays) {
  const Mesh whole = shapes::voxels(3, 3, 1, [](int x, int y, int) { return x != 1 || y != 1; });
  const Built expected = built(whole);
  EXPECT_EQ(expected.input.turned_parts, 0u);
  EXPECT_NEAR(expected.volume, shapes::signed_volume(whole), 1e-6);
}

// The other rules take the surface as it is turned.
TEST(InvertedParts, ExplicitRulesTurnNoPart) {
  const Mesh mesh = shapes::merged({box_at(0, 2), shapes::inverted(box_at(5, 1))});
  EXPECT_NEAR(built(mesh, InsideRule::kPositive).volume, 8, 1e-6);
  EXPECT_NEAR(built(mesh, InsideRule::kNonzero).volume, 9, 1e-6);
  EXPECT_EQ(built(mesh, InsideRule::kNonzero).input.turned_parts, 0u);
}

// Blocks of voxels touch along edges and at corners in every way, and have cavities; as they are
// turned outwards, nothing may be turned.
TEST(InvertedParts, VoxelsStayAsTheyAre) {
  for (std::uint32_t seed = 0; seed < (check::kSanitized ? 60 : 300); ++seed) {
    const Mesh mesh = shapes::random_voxels(3 + seed % 3, 0.3 + 0.1 * (seed % 6), seed);
    if (mesh.triangles.empty()) continue;
    const Grid grid = build_grid(mesh, {.tolerance = 0.01});
    EXPECT_EQ(grid.input().turned_parts, 0u) << seed;
    EXPECT_FALSE(grid.input().flipped) << seed;
  }
}

TEST(InvertedParts, ThousandsThatOverlapAreLeftAsTheyAre) {
  std::vector<Mesh> parts;
  for (int i = 0; i < 9000; ++i) {
    const Mesh box = shapes::box(Vec3::Constant(-1 - i), Vec3::Constant(1 + i));
    parts.push_back(i % 2 == 0 ? box : shapes::inverted(box));
  }
  const InvertedParts found = inverted_parts_of(shapes::merged(parts));
  EXPECT_FALSE(found.nesting_known);
  EXPECT_EQ(found.parts, 0u);
}

TEST(InvertedParts, TheReportIsSavedWithTheGrid) {
  const Mesh mesh = shapes::merged({box_at(0, 1), shapes::inverted(box_at(5, 2))});
  const Grid grid = build_grid(mesh);
  const Grid loaded = load_grid(save_grid(grid));
  EXPECT_EQ(loaded.input().turned_parts, 1u);
  EXPECT_TRUE(loaded.input().nesting_known);
}

}  // namespace
}  // namespace kdm
