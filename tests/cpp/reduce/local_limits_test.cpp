// SPDX-License-Identifier: MIT
#include "reduce/local_limits.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "kdmanifold/reduce.h"
#include "support/mesh_check.h"
#include "support/shapes.h"

namespace kdm {
namespace {

LocalLimits limits_of(const Mesh& mesh, double error) {
  const ScaledMesh scaled = scaled_mesh(mesh, 0);
  const Reference surface(scaled.all_corners());
  return local_limits(scaled, surface, surface,
                      std::vector<TriangleId>(mesh.positions.size(), kNone), error);
}

TEST(LocalLimits, AreAnEighthOfAThinWall) {
  const Mesh plate =
      shapes::subdivided(shapes::subdivided(shapes::box(Vec3(0, 0, 0), Vec3(1, 1, 0.02))));
  const std::vector<double> limits = limits_of(plate, 0.01).distance;
  for (std::size_t v = 0; v < plate.positions.size(); ++v) {
    const Vec3& p = plate.positions[v];
    const bool inside = p.x() > 0.1 && p.x() < 0.9 && p.y() > 0.1 && p.y() < 0.9;
    if (!inside) continue;
    EXPECT_NEAR(limits[v], 0.02 / 8, 1e-6);
  }
}

// The edges of a rod have no wall behind them, but their sides have.
TEST(LocalLimits, AreAnEighthOfAThinRodAlongItsEdges) {
  Mesh rod = shapes::box(Vec3(0, 0, 0), Vec3(1, 0.02, 0.02));
  for (int i = 0; i < 4; ++i) rod = shapes::subdivided(rod);
  const std::vector<double> limits = limits_of(rod, 0.01).distance;
  for (std::size_t v = 0; v < rod.positions.size(); ++v) {
    const Vec3& p = rod.positions[v];
    if (p.x() == 0 || p.x() == 1) continue;
    EXPECT_NEAR(limits[v], 0.02 / 8, 1e-6) << p.transpose();
  }
}

// A straight rod of many triangles lost 40 % of its volume.
TEST(LocalLimits, KeepRodsAsThickAsTheyAre) {
  Mesh rod = shapes::box(Vec3(0, 0, 0), Vec3(1, 0.003, 0.003));
  for (int i = 0; i < 3; ++i) rod = shapes::subdivided(rod);
  const Mesh turned = shapes::rotated(rod, Vec3(1, 2, 3), 0.7);
  for (const Mesh& mesh : {rod, turned}) {
    const double volume = check::check_mesh(mesh).volume;
    const ReducedMesh few = reduce(mesh, mesh, {.error = 0.007});
    EXPECT_NEAR(check::check_mesh(few).volume, volume, 0.06 * volume);
    EXPECT_LT(few.triangles.size(), mesh.triangles.size() / 4);
  }
}

TEST(LocalLimits, AreTheErrorWhereNothingIsThin) {
  for (const Mesh& mesh : {shapes::cube(), shapes::icosphere(3)}) {
    for (const double limit : limits_of(mesh, 0.01).distance) EXPECT_EQ(limit, 0.01);
  }
  // Gaps are not walls.
  const Mesh cubes = shapes::merged(
      {shapes::box(Vec3(0, 0, 0), Vec3(1, 1, 1)), shapes::box(Vec3(1.01, 0, 0), Vec3(2, 1, 1))});
  for (const double limit : limits_of(cubes, 0.01).distance) EXPECT_EQ(limit, 0.01);
}

// Two plates, 0.5 thick, with a gap between them.
Mesh plates(double gap) {
  const Mesh plate =
      shapes::subdivided(shapes::subdivided(shapes::box(Vec3(0, 0, 0), Vec3(1, 1, 0.5))));
  return shapes::merged({plate, shapes::translated(plate, Vec3(0, 0, 0.5 + gap))});
}

TEST(LocalLimits, MarkWhatIsNearToAnotherWall) {
  const Mesh apart = plates(0.03);
  const Marks narrow = limits_of(apart, 0.01).narrow;
  for (std::size_t v = 0; v < apart.positions.size(); ++v) {
    const Vec3& p = apart.positions[v];
    const bool amid = p.x() > 0.1 && p.x() < 0.9 && p.y() > 0.1 && p.y() < 0.9;
    if (!amid) continue;
    EXPECT_EQ(narrow.test(v), p.z() > 0.4 && p.z() < 0.6) << p.transpose();
  }
  EXPECT_FALSE(limits_of(plates(0.05), 0.01).narrow.any());
  const Mesh thin = shapes::subdivided(shapes::box(Vec3(0, 0, 0), Vec3(1, 1, 0.03)));
  EXPECT_TRUE(limits_of(thin, 0.01).narrow.any());
}

// A bowl whose wall is a fifth of the error must not become a film or a lump.
TEST(LocalLimits, KeepThinWallsFromVanishing) {
  const Mesh shell =
      shapes::merged({shapes::icosphere(4, 1), shapes::inverted(shapes::icosphere(4, 0.99))});
  const double volume = check::check_mesh(shell).volume;
  const ReducedMesh few = reduce(shell, shell, {.error = 0.05});
  EXPECT_NEAR(check::check_mesh(few).volume, volume, 0.25 * volume);
  EXPECT_LT(few.triangles.size(), shell.triangles.size());
}

}  // namespace
}  // namespace kdm
