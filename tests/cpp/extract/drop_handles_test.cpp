// SPDX-License-Identifier: MIT
// Tunnels closed and bridges cut in results.
#include "extract/drop_handles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "kdmanifold/build.h"
#include "kdmanifold/error.h"
#include "kdmanifold/extract.h"
#include "kdmanifold/make_manifold.h"
#include "support/mesh_check.h"
#include "support/random_meshes.h"
#include "support/shapes.h"

namespace kdm {
namespace {

// Returns how many handles an embedded mesh has: each part has an Euler characteristic of 2 - 2 *
// handles.
int handles_of(const Mesh& mesh) {
  const check::MeshCheck found = check::check_mesh(mesh);
  EXPECT_TRUE(found.two_manifold) << found.faults();
  EXPECT_EQ(find_self_intersections(mesh).pairs, 0u);
  return static_cast<int>((2 * found.components - found.euler_characteristic) / 2);
}

ExtractedMesh without_handles(const Mesh& mesh, double size, double tolerance = 0.01) {
  return extract(build_grid(mesh, {.tolerance = tolerance}), {.drop_handles = size});
}

std::vector<std::string> codes_of(const ExtractedMesh& mesh) {
  std::vector<std::string> codes;
  for (const Warning& warning : mesh.warnings) codes.push_back(warning.code);
  return codes;
}

// A plate of 13 x 9 x 4 with a hole of 1 x 1 and one of 3 x 3, both 3 from its sides and each
// other.
Mesh plate() {
  return shapes::voxels(13, 9, 4, [](int x, int y, int) {
    return !(x == 3 && y == 4) && !(x >= 7 && x <= 9 && y >= 3 && y <= 5);
  });
}

// Two blocks that a bar of 1 x 1 and one of 2 x 2 join.
Mesh two_bridges() {
  return shapes::voxels(12, 4, 6, [](int x, int y, int z) {
    return x < 4 || x >= 8 || (y == 1 && z == 1) || (y >= 1 && y <= 2 && z >= 3 && z <= 4);
  });
}

TEST(DropHandles, TunnelsGoByTheirCircumference) {
  const double whole = describe(without_handles(plate(), 0)).volume;
  struct Expected {
    double size;
    Index dropped;
    double filled;
  };
  for (const Expected& e : {Expected{3.8, 0, 0}, {4.2, 1, 4}, {11, 1, 4}, {13, 2, 40}}) {
    SCOPED_TRACE(e.size);
    const ExtractedMesh out = without_handles(plate(), e.size);
    EXPECT_EQ(out.report.small_handles, e.dropped);
    EXPECT_EQ(out.report.kept_handles, 0u);
    EXPECT_EQ(handles_of(out), 2 - static_cast<int>(e.dropped));
    EXPECT_EQ(describe(out).components, 1u);
    const double added = describe(out).volume - whole;
    EXPECT_GE(added, 0);  // a wall somewhere in the hole
    EXPECT_LE(added, e.filled);
    EXPECT_EQ(codes_of(out), e.dropped > 0 ? std::vector<std::string>{"HANDLES_REMOVED"}
                                           : std::vector<std::string>{});
  }
}

TEST(DropHandles, BridgesAreCutAtTheThinnest) {
  const double whole = describe(without_handles(two_bridges(), 0)).volume;
  const ExtractedMesh out = without_handles(two_bridges(), 4.2);
  EXPECT_EQ(out.report.small_handles, 1u);
  EXPECT_EQ(handles_of(out), 0);
  EXPECT_EQ(describe(out).components, 1u);
  EXPECT_LT(describe(out).volume, whole);
  EXPECT_GT(describe(out).volume, whole - 4);
}

// A ring of the same form is cut through where it is thin, and filled where its hole is narrow.
TEST(DropHandles, TheShorterLoopOfAHandleIsCut) {
  for (const double minor : {0.3, 0.8}) {
    SCOPED_TRACE(minor);
    const Mesh ring = shapes::torus(1, minor);
    const double through = 6.2832 * minor;
    const double around = 6.2832 * (1 - minor);
    const double size = 1.1 * std::min(through, around);
    EXPECT_EQ(handles_of(without_handles(ring, 0.85 * std::min(through, around))), 1);
    const ExtractedMesh out = without_handles(ring, size);
    EXPECT_EQ(handles_of(out), 0);
    const double added = describe(out).volume - describe(without_handles(ring, 0)).volume;
    EXPECT_EQ(added > 0, around < through) << added;
  }
}

// A rod fills the hole of a thick ring, so the ring can only be cut through.
TEST(DropHandles, WhatNothingClosesIsTold) {
  const Mesh mesh = shapes::merged(
      {shapes::torus(1, 0.6), shapes::translated(shapes::cylinder(0.1, 6, 12), Vec3(0, 0, -3))});
  const ExtractedMesh kept = without_handles(mesh, 3);
  EXPECT_EQ(kept.report.small_handles, 0u);
  EXPECT_EQ(kept.report.kept_handles, 1u);
  EXPECT_EQ(codes_of(kept), std::vector<std::string>{"HANDLES_KEPT"});
  EXPECT_EQ(handles_of(kept), 1);
  EXPECT_EQ(kept.positions, without_handles(mesh, 0).positions);
  const ExtractedMesh cut = without_handles(mesh, 5);
  EXPECT_EQ(cut.report.small_handles, 1u);
  EXPECT_EQ(cut.report.kept_handles, 0u);
  EXPECT_EQ(handles_of(cut), 0);
}

TEST(DropHandles, AllOfThemGoAtAnyLength) {
  for (const Mesh& mesh : {shapes::torus_chain(4), shapes::plate_with_holes(4, 3)}) {
    const ExtractedMesh plain = without_handles(mesh, 0);
    const int before = handles_of(plain);
    const ExtractedMesh out = without_handles(mesh, 1e9);
    EXPECT_EQ(static_cast<int>(out.report.small_handles), before);
    EXPECT_EQ(out.report.kept_handles, 0u);
    EXPECT_EQ(handles_of(out), 0);
    EXPECT_EQ(describe(out).components, describe(plain).components);
    EXPECT_EQ(describe(out).unreferenced_vertices, 0u);
  }
}

// Each loop of random solids in contact is either cut or told, and the account is exact.
TEST(DropHandles, CountsAreExact) {
  const Mesh mesh = shapes::random_voxels(6, 0.5, 3);
  for (const double size : {4.5, 1e9}) {
    SCOPED_TRACE(size);
    const int before = handles_of(without_handles(mesh, 0, 0.05));
    const ExtractedMesh out = without_handles(mesh, size, 0.05);
    EXPECT_GT(out.report.small_handles, 0u);
    EXPECT_EQ(handles_of(out), before - static_cast<int>(out.report.small_handles));
    EXPECT_LE(static_cast<int>(out.report.kept_handles), handles_of(out));
  }
}

TEST(DropHandles, NewFacesHaveNormalsAndNoSource) {
  const Grid grid = build_grid(plate(), {.tolerance = 0.01});
  const ExtractedMesh plain = extract(grid, {.normals = true});
  const ExtractedMesh out = extract(grid, {.drop_handles = 100, .normals = true});
  ASSERT_EQ(out.source_faces.size(), out.triangles.size());
  ASSERT_EQ(out.corner_normals.size(), 3 * out.triangles.size());
  for (std::size_t t = 0; t < out.triangles.size(); ++t) {
    EXPECT_EQ(out.source_faces[t] == kNone, t >= plain.triangles.size());
    for (std::size_t i = 3 * t; i < 3 * t + 3; ++i) {
      const auto& n = out.corner_normals[i];
      EXPECT_NEAR(n[0] * n[0] + n[1] * n[1] + n[2] * n[2], 1, 1e-5);
    }
  }
}

// Also of Boolean operations, and through the reducer.
TEST(DropHandles, ReducedResultsHaveOneHandleLess) {
  const MadeMesh out = make_manifold(
      two_bridges(), {.build = {.tolerance = 0.01}, .extract = {.drop_handles = 4.2}});
  EXPECT_EQ(handles_of(out), 0);
  EXPECT_EQ(out.report.small_handles, 1u);
}

TEST(DropHandles, RefusesSheetsAndQuads) {
  const auto message = [](const BuildOptions& build, const ExtractOptions& options) -> std::string {
    try {
      extract(build_grid(shapes::cube(), build), options);
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(message({.inside = InsideRule::kSheet}, {.drop_handles = 1}),
            "`drop_handles`: not for a sheet, which encloses nothing");
  EXPECT_EQ(message({}, {.quads = true, .strict = Strict::kManifold, .drop_handles = 1}),
            "`drop_handles`: not together with `quads`");
  EXPECT_EQ(message({}, {.strict = Strict::kOff, .drop_handles = 1}),
            "`drop_handles`: not together with `strict` off");
  EXPECT_EQ(message({}, {.drop_handles = -1}), "drop_handles is -1; it must be a number from 0 on");
}

}  // namespace
}  // namespace kdm
