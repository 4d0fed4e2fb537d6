// SPDX-License-Identifier: MIT
// Meshes that are closed and embedded are reduced as they are, all others are made so first.
#include <gtest/gtest.h>

#include <cmath>

#include "kdmanifold/error.h"
#include "kdmanifold/make_manifold.h"
#include "support/mesh_assert.h"
#include "support/shapes.h"

namespace kdm {
namespace {

void expect_sound(const Mesh& mesh) {
  EXPECT_TRUE(check::is_two_manifold(mesh));
  EXPECT_EQ(find_self_intersections(mesh).pairs, 0u);
}

TEST(SimplifyMesh, TakesWhatIsSoundAsItIs) {
  const Mesh torus = shapes::torus();
  const SimplifiedMesh few = simplify_mesh(torus, {.error = 0.02});
  expect_sound(few.mesh);
  EXPECT_FALSE(few.rebuilt);
  EXPECT_TRUE(few.warnings.empty());
  EXPECT_EQ(few.report.triangles_before, torus.triangles.size());
  EXPECT_EQ(few.report.triangles, few.mesh.triangles.size());
  EXPECT_EQ(few.mesh.source_faces.size(), few.mesh.triangles.size());
  EXPECT_LT(2 * few.mesh.triangles.size(), torus.triangles.size());
  EXPECT_NEAR(describe(few.mesh).volume, describe(torus).volume, 0.1);
  EXPECT_EQ(
      simplify_mesh(shapes::subdivided(shapes::cube()), {.error = 0.01}).mesh.triangles.size(),
      12u);
}

TEST(SimplifyMesh, JoinsVerticesOfEqualPosition) {
  const SimplifiedMesh few = simplify_mesh(shapes::soup(shapes::torus()), {.error = 0.02});
  expect_sound(few.mesh);
  EXPECT_FALSE(few.rebuilt);
  EXPECT_EQ(few.report.triangles_before, shapes::torus().triangles.size());
}

TEST(SimplifyMesh, MakesOthersAnewFirst) {
  for (const Mesh& mesh : {shapes::open(shapes::cube(), 2), shapes::overlapping_cubes(),
                           shapes::inverted(shapes::cube())}) {
    for (const ReduceOptions& options :
         {ReduceOptions{.error = 0.02}, ReduceOptions{.target_triangles = {40}},
          ReduceOptions{.error = 0.02, .target_triangles = {60, 40}}}) {
      const SimplifiedMesh few = simplify_mesh(mesh, options);
      expect_sound(few.mesh);
      EXPECT_TRUE(few.rebuilt);
      EXPECT_GT(describe(few.mesh).volume, 0.9);
      EXPECT_EQ(few.levels.size(), options.target_triangles.size());
      EXPECT_LE(few.mesh.triangles.size(), 60u);
    }
  }
  const SimplifiedMesh closed = simplify_mesh(shapes::open(shapes::cube(), 2), {.error = 0.02});
  ASSERT_EQ(closed.warnings.size(), 1u);
  EXPECT_EQ(closed.warnings[0].code, "HOLES_CLOSED");
}

TEST(SimplifyMesh, MakesSeveralLevels) {
  const SimplifiedMesh few = simplify_mesh(shapes::torus(), {.target_triangles = {1000, 100}});
  ASSERT_EQ(few.levels.size(), 2u);
  for (const Mesh& level : few.levels) expect_sound(level);
  EXPECT_LE(few.levels[0].triangles.size(), 1000u);
  EXPECT_GT(few.levels[0].triangles.size(), 900u);
  EXPECT_LE(few.levels[1].triangles.size(), 100u);
  EXPECT_EQ(few.mesh.triangles, few.levels[1].triangles);
}

TEST(SimplifyMesh, WantsToKnowHowFar) {
  const auto complaint = [](const Mesh& mesh, const ReduceOptions& options) {
    try {
      simplify_mesh(mesh, options);
    } catch (const Error& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_EQ(complaint(shapes::cube(), {}),
            "error is 0; it must be above 0, or target_triangles given");
  EXPECT_EQ(complaint(shapes::cube(), {.error = -1}), "error is -1; it must be a number from 0 on");
  Mesh broken = shapes::cube();
  broken.positions[3].y() = std::nan("");
  EXPECT_NE(complaint(broken, {.error = 1}), "");
  broken = shapes::cube();
  broken.triangles[0][0] = 8;
  EXPECT_NE(complaint(broken, {.error = 1}), "");
}

}  // namespace
}  // namespace kdm
