// SPDX-License-Identifier: MIT
// Parts left out of results.
#include "extract/keep_parts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <initializer_list>
#include <string>
#include <vector>

#include "kdmanifold/build.h"
#include "kdmanifold/error.h"
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

// Diagonals: 10.39 and 6.93 of the balls' shells, 3.46 of the small ball and of the box.
TEST(KeepParts, SmallPartsAndCavitiesGo) {
  const Grid grid = build_grid(scene(), {.relative_tolerance = 0.001});
  const double whole = describe(extract(grid)).volume;
  struct Expected {
    double parts;
    double cavities;
    Index small_parts;
    Index small_cavities;
    int components;
  };
  for (const Expected& e : std::initializer_list<Expected>{{3.4, 6.8, 0, 0, 4},
                                                           {3.6, 0, 2, 0, 2},
                                                           {3.4, 7, 0, 1, 2},
                                                           {3.6, 7, 1, 1, 1},
                                                           {0, 100, 0, 1, 2}}) {
    SCOPED_TRACE(e.parts * 1000 + e.cavities);
    const ExtractedMesh out = extract(grid, {.drop_parts = e.parts, .drop_cavities = e.cavities});
    const check::MeshCheck mesh = check::check_mesh(out);
    EXPECT_TRUE(mesh.two_manifold) << mesh.faults();
    EXPECT_EQ(mesh.components, e.components);
    EXPECT_EQ(out.report.small_parts, e.small_parts);
    EXPECT_EQ(out.report.small_cavities, e.small_cavities);
    EXPECT_EQ(out.report.dropped_parts, 0u);
    EXPECT_NEAR(mesh.volume,
                whole - out.report.small_parts_volume + out.report.small_cavities_volume, 1e-4);
    EXPECT_EQ(out.report.small_parts_volume > 0, e.small_parts > 0);
    EXPECT_EQ(out.report.small_cavities_volume > 0, e.small_cavities > 0);
    std::vector<std::string> codes;
    for (const Warning& warning : out.warnings) codes.push_back(warning.code);
    EXPECT_EQ(std::count(codes.begin(), codes.end(), "PARTS_DROPPED"), e.small_parts > 0 ? 1 : 0);
    EXPECT_EQ(std::count(codes.begin(), codes.end(), "CAVITIES_FILLED"),
              e.small_cavities > 0 ? 1 : 0);
  }
}

// A part goes with its cavity, and that is one part, with the volume of its wall.
TEST(KeepParts, WhatLiesInSmallPartsGoesWithThem) {
  Mesh mesh = shapes::merged(
      {shapes::box(Vec3(-9, -9, -9), Vec3(9, 9, 9)),
       shapes::translated(shapes::cube(), Vec3(20, 0, 0)),
       shapes::inverted(shapes::box(Vec3(20.25, 0.25, 0.25), Vec3(20.75, 0.75, 0.75)))});
  mesh.source_faces.assign(mesh.triangles.size(), 7);
  const KeptParts kept = keep_parts({.drop_parts = 2}, 0.01, mesh);
  EXPECT_EQ(kept.small_parts.count, 1u);
  EXPECT_DOUBLE_EQ(kept.small_parts.volume, 0.875);
  EXPECT_EQ(kept.small_cavities.count, 0u);
  EXPECT_EQ(mesh.triangles.size(), 12u);
}

// Too many shells overlap to find out what lies in what: cavities in parts that go do so too.
TEST(KeepParts, NothingIsLeftOverWhereNestingIsUnknown) {
  Mesh mesh = shapes::box(Vec3(-9, -9, -9), Vec3(9, 9, 9));
  for (int i = 0; i < 7000; ++i) {
    const double size = 0.5 - 0.00001 * i;
    const Mesh shell = shapes::box(Vec3(20 - size, -size, -size), Vec3(20 + size, size, size));
    const Mesh turned = i % 2 == 0 ? shell : shapes::inverted(shell);
    const auto first = static_cast<Index>(mesh.positions.size());
    mesh.positions.insert(mesh.positions.end(), turned.positions.begin(), turned.positions.end());
    for (const Triangle& t : turned.triangles) {
      mesh.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
    }
  }
  mesh.source_faces.assign(mesh.triangles.size(), 7);
  const KeptParts kept = keep_parts({.drop_parts = 2}, 0.0001, mesh);
  EXPECT_EQ(kept.small_parts.count, 3500u);
  EXPECT_EQ(kept.small_cavities.count, 3500u);
  EXPECT_EQ(mesh.triangles.size(), 12u);
}

TEST(KeepParts, RefusesToDropEverythingAndSheets) {
  const Grid grid = build_grid(shapes::cube(), {.tolerance = 0.01});
  EXPECT_EQ(extract(grid, {.drop_parts = 1.7}).triangles.size(), extract(grid).triangles.size());
  const auto message = [](const Grid& of, const ExtractOptions& options) -> std::string {
    try {
      extract(of, options);
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(message(grid, {.drop_parts = 1.8}),
            "all parts of the result are smaller than `drop_parts`");
  const Grid sheet = build_grid(shapes::cube(), {.tolerance = 0.01, .inside = InsideRule::kSheet});
  EXPECT_EQ(message(sheet, {.drop_parts = 1}),
            "`drop_parts`: not for a sheet, which encloses nothing");
  EXPECT_EQ(message(sheet, {.drop_cavities = 1}),
            "`drop_cavities`: not for a sheet, which encloses nothing");
  EXPECT_EQ(message(grid, {.drop_parts = -1}), "drop_parts is -1; it must be a number from 0 on");
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
    const KeptParts kept = keep_parts({}, 0.01, mesh);
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
