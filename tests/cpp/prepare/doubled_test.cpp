// SPDX-License-Identifier: MIT
// Of faces that all lie back to back, as in game assets, one copy counts.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "kdmanifold/build.h"
#include "kdmanifold/error.h"
#include "kdmanifold/extract.h"
#include "prepare/two_sided.h"
#include "support/mesh_check.h"
#include "support/shapes.h"

namespace kdm {
namespace {

Mesh with_backs(Mesh mesh) {
  const std::vector<Triangle> faces = mesh.triangles;
  for (const Triangle& t : faces) mesh.triangles.push_back({t[0], t[2], t[1]});
  return mesh;
}

Mesh square() {
  Mesh mesh;
  mesh.positions = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 1, 0), Vec3(0, 1, 0)};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

bool some_part_of_it_has_two_sides(const Mesh& mesh) {
  const auto points = static_cast<Index>(mesh.positions.size());
  return some_part_has_two_sides(mesh.triangles, mesh.positions,
                                 build_topology(mesh.triangles, points));
}

TEST(Doubled, PartsThatConsistOfPairsAreFound) {
  EXPECT_TRUE(some_part_of_it_has_two_sides(with_backs(shapes::cube())));
  EXPECT_TRUE(
      some_part_of_it_has_two_sides(shapes::merged({shapes::torus(), with_backs(shapes::cube())})));
  EXPECT_FALSE(some_part_of_it_has_two_sides(shapes::cube()));
  EXPECT_FALSE(some_part_of_it_has_two_sides(shapes::cube_with_flaps()));
  EXPECT_FALSE(some_part_of_it_has_two_sides(with_backs(square())));  // too few to enclose anything
}

TEST(Doubled, OneCopyOfEachFaceCounts) {
  for (const Mesh& solid : {shapes::cube(), shapes::icosphere(2)}) {
    const Grid grid = build_grid(with_backs(solid), {.relative_tolerance = 0.005});
    EXPECT_EQ(grid.input().duplicate_faces, solid.triangles.size());
    EXPECT_EQ(grid.input().cancelled_faces, 0u);
    EXPECT_EQ(grid.input().triangles, 2 * solid.triangles.size());
    const check::MeshCheck report = check::check_mesh(extract(grid));
    EXPECT_TRUE(report.two_manifold) << report.faults();
    EXPECT_NEAR(report.volume, shapes::signed_volume(solid), 0.05);
    EXPECT_EQ(report.components, 1);
  }
}

TEST(Doubled, OtherPartsStayAsTheyAre) {
  const Mesh beside = shapes::translated(with_backs(shapes::cube()), Vec3(3, 0, 0));
  const Mesh mesh = extract(build_grid(shapes::merged({shapes::cube(), beside})));
  EXPECT_NEAR(shapes::signed_volume(mesh), 2, 1e-6);
}

// Of a mesh whose triangles form quads, two and two: the backs are cut along the other diagonals,
// as they are where a file gives the front's corners in reverse order.
Mesh with_backs_cut_across(Mesh mesh) {
  const std::vector<Triangle> faces = mesh.triangles;
  for (std::size_t i = 0; i < faces.size(); i += 2) {
    const auto alone = [](const Triangle& t, const Triangle& other) {
      std::size_t k = 0;
      while (std::count(other.begin(), other.end(), t[k]) > 0) ++k;
      return k;
    };
    const std::size_t k = alone(faces[i], faces[i + 1]);
    const Index a = faces[i][(k + 2) % 3], b = faces[i][k], c = faces[i][(k + 1) % 3];
    const Index d = faces[i + 1][alone(faces[i + 1], faces[i])];
    mesh.triangles.push_back({d, c, b});
    mesh.triangles.push_back({d, b, a});
  }
  return mesh;
}

TEST(Doubled, BacksMayBeCutAlongTheOtherDiagonals) {
  const Mesh solid = shapes::torus();
  const Grid grid = build_grid(with_backs_cut_across(solid), {.relative_tolerance = 0.005});
  EXPECT_EQ(grid.input().duplicate_faces, solid.triangles.size());
  EXPECT_TRUE(grid.stats().topology_resolved);
  const check::MeshCheck report = check::check_mesh(extract(grid));
  EXPECT_TRUE(report.two_manifold) << report.faults();
  EXPECT_EQ(report.euler_characteristic, 0);
  const double volume = shapes::signed_volume(solid);
  EXPECT_NEAR(report.volume, volume, 0.02 * volume);
}

// What is between the two ways of cutting is thicker than the tolerance: it is solid.
TEST(Doubled, DiagonalsThatAreFarApartStay) {
  Mesh mesh;
  mesh.positions = {Vec3(0, 0, 0), Vec3(1, 0, 0.5), Vec3(1, 1, 0), Vec3(0, 1, 0.5)};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  const Mesh tetrahedron = shapes::inverted(with_backs_cut_across(mesh));
  // Two of them that share an edge, so that it has four faces.
  const Vec3 twice_the_middle = mesh.positions[1] + mesh.positions[2];
  const Mesh two =
      shapes::merged({tetrahedron, shapes::translated(shapes::scaled(tetrahedron, Vec3(-1, -1, -1)),
                                                      twice_the_middle)});
  const double volume = shapes::signed_volume(two);
  EXPECT_NEAR(volume, 1.0 / 3, 1e-12);
  const Grid grid = build_grid(two, {.relative_tolerance = 0.01});
  EXPECT_EQ(grid.input().non_manifold_edges, 1u);
  EXPECT_EQ(grid.input().cancelled_faces, 0u);
  EXPECT_NEAR(shapes::signed_volume(extract(grid)), volume, 0.03);
}

// A prism whose lids are cut from one corner in front and from another one at the back.
TEST(Doubled, SomeBacksMayBeCutInAnyOtherWay) {
  constexpr Index kSides = 9;
  Mesh prism;
  for (Index i = 0; i < 2 * kSides; ++i) {
    const double angle = 2 * std::numbers::pi * (i % kSides) / kSides;
    prism.positions.emplace_back(std::cos(angle), std::sin(angle), i < kSides ? 0 : 2);
  }
  for (Index i = 0; i < kSides; ++i) {
    const Index next = (i + 1) % kSides;
    prism.triangles.push_back({i, next, next + kSides});
    prism.triangles.push_back({i, next + kSides, i + kSides});
  }
  prism = with_backs(std::move(prism));
  const auto add_lids = [&](Index first, bool back) {
    for (Index i = 1; i + 1 < kSides; ++i) {
      const Index a = first, b = (first + i) % kSides, c = (first + i + 1) % kSides;
      Triangle lower{a, c, b};
      Triangle upper{a + kSides, b + kSides, c + kSides};
      if (back) std::swap(lower[1], lower[2]);
      if (back) std::swap(upper[1], upper[2]);
      prism.triangles.push_back(lower);
      prism.triangles.push_back(upper);
    }
  };
  add_lids(0, false);
  add_lids(4, true);
  EXPECT_TRUE(some_part_of_it_has_two_sides(prism));
  const check::MeshCheck report =
      check::check_mesh(extract(build_grid(prism, {.relative_tolerance = 0.002})));
  EXPECT_TRUE(report.two_manifold) << report.faults();
  EXPECT_EQ(report.components, 1);
  const double area = kSides * std::sin(2 * std::numbers::pi / kSides) / 2;
  EXPECT_NEAR(report.volume, 2 * area, 0.02);
}

TEST(Doubled, ASheetIsRefusedWithAdvice) {
  for (const Mesh& sheet : {square(), shapes::subdivided(square())}) {
    try {
      build_grid(with_backs(sheet));
      FAIL() << "accepted";
    } catch (const Error& error) {
      EXPECT_NE(std::string(error.what()).find("thicken"), std::string::npos) << error.what();
    }
  }
}

// Where only odd winding numbers are inside, two copies bound nothing. As long as they were kept,
// cells were split between them down to the finest ones.
TEST(Doubled, CopiesCancelWhereOddNumbersAreInside) {
  const Mesh ball = shapes::icosphere(2);
  const Mesh other = shapes::translated(ball, Vec3(0.9, 0.1, 0));
  const BuildOptions options{.relative_tolerance = 0.01, .inside = InsideRule::kOdd};
  const Grid once = build_grid(shapes::merged({ball, other}), options);
  const Grid thrice = build_grid(shapes::merged({ball, ball, other, ball}), options);
  EXPECT_EQ(thrice.input().duplicate_faces, 2 * ball.triangles.size());
  EXPECT_EQ(thrice.stats().cells, once.stats().cells);
  EXPECT_EQ(thrice.stats().hits, once.stats().hits);
  const Grid alone = build_grid(other, options);
  const Grid twice = build_grid(shapes::merged({ball, other, ball}), options);
  EXPECT_EQ(twice.input().duplicate_faces, 2 * ball.triangles.size());
  EXPECT_NEAR(shapes::signed_volume(extract(twice)), shapes::signed_volume(extract(alone)), 0.06);
  EXPECT_LT(twice.stats().cells, 4 * alone.stats().cells);
  try {
    build_grid(shapes::merged({ball, ball}), options);
    FAIL() << "nothing is enclosed";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kNotClosed);
    EXPECT_NE(std::string(error.what()).find("even number of times"), std::string::npos);
  }
}

}  // namespace
}  // namespace kdm
