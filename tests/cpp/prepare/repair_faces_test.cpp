// SPDX-License-Identifier: MIT
// What becomes of open, doubled and torn input: closed exactly where that is possible.
#include "prepare/repair_faces.h"

#include <gtest/gtest.h>

#include "grid/validate.h"
#include "kdmanifold/build.h"
#include "kdmanifold/error.h"
#include "kdmanifold/extract.h"
#include "kdmanifold/grid_io.h"
#include "support/mesh_check.h"
#include "support/random.h"
#include "support/sanitized.h"
#include "support/shapes.h"

namespace kdm {
namespace {

struct Result {
  InputReport input;
  GridStats grid;
  ExtractedMesh mesh;
  check::MeshCheck check;
};

Result converted(const Mesh& mesh, BuildOptions options = {.relative_tolerance = 0.005}) {
  const Grid grid = build_grid(mesh, options);
  EXPECT_NO_THROW(validate(grid.data()));
  Result result{grid.input(), grid.stats(), extract(grid), {}};
  result.check = check::check_mesh(result.mesh);
  EXPECT_TRUE(result.check.two_manifold) << result.check.faults();
  return result;
}

Mesh square(double z) {
  Mesh mesh;
  mesh.positions = {Vec3(0, 0, z), Vec3(1, 0, z), Vec3(1, 1, z), Vec3(0, 1, z)};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

// A tube along z without its ends.
Mesh tube(double radius, double height) {
  Mesh mesh = shapes::cylinder(radius, height, 32);
  std::erase_if(mesh.triangles, [&](const Triangle& t) {
    return mesh.positions[t[0]].z() == mesh.positions[t[1]].z() &&
           mesh.positions[t[1]].z() == mesh.positions[t[2]].z();
  });
  return mesh;
}

// --- Holes ---------------------------------------------------------------------------------------

TEST(RepairFaces, AnOpenBoxIsTheBoxExactly) {
  const Mesh whole = shapes::rotated(shapes::subdivided(shapes::cube()), Vec3(1, 2, 3), 0.5);
  Mesh open = whole;
  const Vec3 up = (whole.positions[4] - whole.positions[0]).normalized();
  std::erase_if(open.triangles, [&](const Triangle& t) {
    return std::all_of(t.begin(), t.end(),
                       [&](Index v) { return up.dot(whole.positions[v]) < 1e-9; });
  });
  ASSERT_EQ(whole.triangles.size() - open.triangles.size(), 8u);
  const Result result = converted(open);
  EXPECT_EQ(result.input.patched_holes, 1u);
  EXPECT_NEAR(result.input.patch_area, 1, 1e-9);
  EXPECT_NEAR(result.check.volume, 1, 1e-5);
  EXPECT_EQ(result.mesh.triangles.size(), 12u);
  EXPECT_NEAR(result.mesh.report.invented_area, 1, 1e-5);
  EXPECT_TRUE(result.grid.topology_resolved);
  EXPECT_EQ(result.grid.winding_threshold, 0);
  EXPECT_FALSE(result.input.closed);
}

// The rim is not flat; what closes it best is the edge that is missing.
TEST(RepairFaces, ABoxWithoutTwoSidesIsTheBox) {
  Mesh open = shapes::subdivided(shapes::subdivided(shapes::cube()));
  std::erase_if(open.triangles, [&](const Triangle& t) {
    const auto on = [&](int axis) {
      return std::all_of(t.begin(), t.end(),
                         [&](Index v) { return open.positions[v][axis] < 1e-9; });
    };
    return on(0) || on(2);
  });
  const Result result = converted(open);
  EXPECT_EQ(result.input.patched_holes, 1u);
  EXPECT_NEAR(result.input.patch_area, 2, 1e-9);
  EXPECT_NEAR(result.check.volume, 1, 1e-5);
}

TEST(RepairFaces, ATubeGetsTwoFlatEnds) {
  for (const double height : {0.7, 2.0, 9.0}) {
    const Result result = converted(tube(1, height), {.tolerance = 0.002});
    EXPECT_EQ(result.check.euler_characteristic, 2);
    EXPECT_NEAR(result.check.volume, shapes::signed_volume(shapes::cylinder(1, height, 32)),
                0.01 * height);
  }
}

// Its outside and its inside are not joined at the ends.
TEST(RepairFaces, ATubeWithAWallGetsRings) {
  const Mesh mesh = shapes::merged({tube(1, 2), shapes::inverted(tube(0.7, 2))});
  const Result result = converted(mesh);
  EXPECT_EQ(result.check.euler_characteristic, 0);
  EXPECT_EQ(result.check.components, 1);
  EXPECT_NEAR(result.check.volume,
              shapes::signed_volume(shapes::cylinder(1, 2, 32)) -
                  shapes::signed_volume(shapes::cylinder(0.7, 2, 32)),
              0.03);
}

TEST(RepairFaces, HalfABallIsFlatBelow) {
  Mesh half = shapes::uv_sphere(48, 24);
  std::erase_if(half.triangles, [&](const Triangle& t) {
    return std::any_of(t.begin(), t.end(), [&](Index v) { return half.positions[v].z() < -1e-9; });
  });
  const Result result = converted(half);
  EXPECT_EQ(result.check.euler_characteristic, 2);
  EXPECT_NEAR(result.check.volume, 2.09, 0.05);
}

TEST(RepairFaces, AThresholdAsksForTheField) {
  const Mesh open = shapes::open(shapes::cube(), 2);
  const Result result = converted(open, {.relative_tolerance = 0.01, .winding_threshold = 0.5});
  EXPECT_EQ(result.input.patched_holes, 0u);
  EXPECT_EQ(result.grid.winding_threshold, 0.5);
  EXPECT_FALSE(result.grid.topology_resolved);
}

TEST(RepairFaces, WhatIsPatchedIsSavedAsSuch) {
  const Grid grid = build_grid(shapes::open(shapes::cube(), 2));
  const Grid loaded = load_grid(save_grid(grid));
  EXPECT_EQ(loaded.input().patched_holes, 1u);
  EXPECT_EQ(loaded.input().patch_area, grid.input().patch_area);
  EXPECT_EQ(loaded.stats().invented_hits, grid.stats().invented_hits);
  const ExtractedMesh mesh = extract(loaded);
  EXPECT_EQ(mesh.positions, extract(grid).positions);
  EXPECT_NE(std::find(mesh.source_faces.begin(), mesh.source_faces.end(), kNone),
            mesh.source_faces.end());
  for (const Index source : mesh.source_faces) EXPECT_TRUE(source < 10 || source == kNone);
}

// --- Sheets --------------------------------------------------------------------------------------

TEST(RepairFaces, SmallSheetsAreLeftOutAndReported) {
  const Mesh mesh = shapes::merged(
      {shapes::cube(),
       shapes::scaled(shapes::translated(square(0), Vec3(5, 0, 0)), Vec3::Constant(0.3)),
       shapes::scaled(shapes::translated(square(0), Vec3(0, 9, 0)), Vec3::Constant(0.2))});
  const Result result = converted(mesh);
  EXPECT_EQ(result.input.lost_parts, 2u);
  EXPECT_NEAR(result.input.lost_area, 0.13, 1e-9);
  EXPECT_NEAR(result.input.largest_lost, 0.09, 1e-9);
  EXPECT_EQ(result.mesh.triangles.size(), 12u);
  EXPECT_NEAR(result.check.volume, 1, 1e-6);
  EXPECT_NEAR(result.input.extent, std::sqrt(3), 1e-9);  // of what is left
}

TEST(RepairFaces, SheetsGetAThicknessAndSolidsStay) {
  const auto thickened = [](const Mesh& mesh) {
    return converted(mesh,
                     {.tolerance = 0.002, .thicken = 0.02, .thicken_what = ThickenWhat::kSheets});
  };
  // A sheet beside a cube, a fin across its side, and a rib in an open box.
  Mesh fin;
  fin.positions = {{1, 0.2, 0.5}, {2, 0.2, 0.5}, {2, 0.8, 0.5}, {1, 0.8, 0.5}};
  fin.triangles = {{0, 1, 2}, {0, 2, 3}};
  Result result =
      thickened(shapes::merged({shapes::cube(), shapes::translated(fin, Vec3(1, 0, 0))}));
  EXPECT_EQ(result.input.thickened_parts, 1u);
  EXPECT_EQ(result.input.lost_parts, 0u);
  EXPECT_EQ(result.check.components, 2);
  EXPECT_NEAR(result.check.volume, 1 + 0.6 * 0.02, 1e-3);
  result = thickened(shapes::merged({shapes::cube(), shapes::translated(fin, Vec3(-0.1, 0, 0))}));
  EXPECT_EQ(result.input.thickened_parts, 1u);
  EXPECT_EQ(result.check.components, 1) << "it is rooted in the cube";
  EXPECT_NEAR(result.check.volume, 1 + 0.54 * 0.02, 1e-3);
  Mesh open = shapes::open(shapes::cube(), 2);
  result = thickened(shapes::merged({open, shapes::translated(fin, Vec3(2, 0, 0))}));
  EXPECT_EQ(result.input.thickened_parts, 1u);
  EXPECT_NEAR(result.check.volume, 1 + 0.6 * 0.02, 1e-3) << "the open cube is closed by a patch";
  // Nothing but sheets, and nothing but solids.
  result = thickened(fin);
  EXPECT_EQ(result.input.thickened_parts, 1u);
  EXPECT_NEAR(result.check.volume, 0.6 * 0.02, 1e-3);
  result = thickened(shapes::cube());
  EXPECT_EQ(result.input.thickened_parts, 0u);
  EXPECT_NEAR(result.check.volume, 1, 1e-6);
}

TEST(RepairFaces, AFinThatSharesAnEdgeIsRooted) {
  // The cube's top has a vertex row in the middle, from which a fin stands up.
  Mesh cube = shapes::voxels(2, 1, 1, [](int, int, int) { return true; });
  Mesh fin;
  fin.positions = {{1, 0, 1}, {1, 1, 1}, {1, 1, 1.6}, {1, 0, 1.6}};
  fin.triangles = {{0, 1, 2}, {0, 2, 3}};
  const Result result =
      converted(shapes::merged({cube, fin}),
                {.tolerance = 0.002, .thicken = 0.02, .thicken_what = ThickenWhat::kSheets});
  EXPECT_EQ(result.input.thickened_parts, 1u);
  EXPECT_EQ(result.check.components, 1);
  EXPECT_NEAR(result.check.volume, 2 + 0.6 * 0.02, 2e-3);
}

// Walls that are not joined to each other are all that the model has.
TEST(RepairFaces, ABoxOfSixSheetsIsABox) {
  std::vector<Mesh> walls;
  const Mesh cube = shapes::cube();
  for (std::size_t i = 0; i < 12; i += 2) {
    Mesh wall = cube;
    wall.triangles = {cube.triangles[i], cube.triangles[i + 1]};
    for (Vec3& p : wall.positions) {
      p += 0.02 * ((cube.positions[cube.triangles[i][0]] + cube.positions[cube.triangles[i][1]] +
                    cube.positions[cube.triangles[i][2]]) /
                       3 -
                   Vec3::Constant(0.5));
    }
    walls.push_back(wall);
  }
  const Result result = converted(shapes::merged(walls), {.tolerance = 0.001});
  EXPECT_EQ(result.input.lost_parts, 0u);
  EXPECT_NEAR(result.check.volume, 1, 0.1);
}

// A tub whose outside ends above its floor: a patch there would cut the floor off.
TEST(RepairFaces, NoPatchPassesBehindMuchOfItsPart) {
  Mesh tub = shapes::revolved(
      {{0, -0.2}, {1, -0.2}, {1, 0.2}, {1, 0.6}, {1, 1}, {0.9, 1}, {0.9, 0}, {0, 0}}, 64);
  std::erase_if(tub.triangles, [&](const Triangle& t) {
    return std::any_of(t.begin(), t.end(), [&](Index v) { return tub.positions[v].z() < -0.1; });
  });
  const Result result = converted(tub);
  EXPECT_EQ(result.input.patched_holes, 0u);
  EXPECT_TRUE(
      std::any_of(result.mesh.positions.begin(), result.mesh.positions.end(), [](const Vec3& p) {
        return std::abs(p.z()) < 0.02 && p.x() * p.x() + p.y() * p.y() < 0.25;
      }));
}

// --- Torn ----------------------------------------------------------------------------------------

TEST(RepairFaces, WhatIsTornIsSewnFurther) {
  const Mesh torn = shapes::jittered(shapes::soup(shapes::icosphere(3)), 0.01, 9);
  const Result result = converted(torn, {.relative_tolerance = 0.001});
  EXPECT_GT(result.input.sewing_distance, 2 * result.grid.tolerance);
  EXPECT_LE(result.input.sewing_distance, 16.001 * result.grid.tolerance);
  EXPECT_EQ(result.check.components, 1);
  EXPECT_NEAR(result.check.volume, 4.1, 0.15);
}

TEST(RepairFaces, WhatIsOpenIsNotTorn) {
  EXPECT_EQ(converted(tube(1, 2)).input.sewing_distance, 0);
  EXPECT_EQ(converted(shapes::open(shapes::cube(), 2)).input.sewing_distance, 0);
}

// --- Hostile -------------------------------------------------------------------------------------

TEST(RepairFaces, AnythingComesToAnEnd) {
  check::Random random(3);
  for (int round = 0; round < (check::kSanitized ? 10 : 60); ++round) {
    Mesh mesh;
    const Index points = 4 + random.below(20);
    for (Index i = 0; i < points; ++i) {
      const Vec3 p = random.point(0, 1);
      mesh.positions.push_back(round % 2 == 0 ? Vec3((p * 3).array().floor()) : p);
    }
    for (Index i = 0; i < 40; ++i) {
      mesh.triangles.push_back({random.below(points), random.below(points), random.below(points)});
    }
    try {
      converted(mesh, {.relative_tolerance = 0.02});
    } catch (const Error& error) {
      EXPECT_TRUE(error.code() == ErrorCode::kNotClosed || error.code() == ErrorCode::kInvalidMesh)
          << error.what();
    }
  }
}

}  // namespace
}  // namespace kdm
