// SPDX-License-Identifier: MIT
// Of faces that all lie back to back, as in game assets, one copy counts.
#include <gtest/gtest.h>

#include "kdmanifold/build.h"
#include "kdmanifold/error.h"
#include "kdmanifold/extract.h"
#include "prepare/cancel.h"
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

bool some_part_of_cancels(const Mesh& mesh) {
  const auto points = static_cast<Index>(mesh.positions.size());
  return some_part_cancels(mesh.triangles, points, build_topology(mesh.triangles, points));
}

TEST(Doubled, PartsThatCancelWhollyAreFound) {
  EXPECT_TRUE(some_part_of_cancels(with_backs(shapes::cube())));
  EXPECT_TRUE(some_part_of_cancels(shapes::merged({shapes::torus(), with_backs(shapes::cube())})));
  EXPECT_FALSE(some_part_of_cancels(shapes::cube()));
  EXPECT_FALSE(some_part_of_cancels(shapes::cube_with_flaps()));
  EXPECT_FALSE(some_part_of_cancels(with_backs(square())));  // too few to enclose anything
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

}  // namespace
}  // namespace kdm
