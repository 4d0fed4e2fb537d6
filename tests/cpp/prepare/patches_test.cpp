// SPDX-License-Identifier: MIT
// Holes are closed by patches: flat ones in their planes, with holes in them where rounds lie in
// each other.
#include "prepare/patches.h"

#include <gtest/gtest.h>

#include "geometry/triangle.h"
#include "mesh/topology.h"
#include "support/mesh_check.h"
#include "support/sanitized.h"
#include "support/shapes.h"

namespace kdm {
namespace {

struct Patched {
  std::vector<Patch> patches;
  Mesh mesh;  // with the patches
};

Patched patched(const Mesh& mesh, double flatness = 1e-3) {
  const auto points = static_cast<Index>(mesh.positions.size());
  const Topology topology = build_topology(mesh.triangles, points);
  const std::vector<Hole> holes = find_holes(mesh.triangles, points, topology.opposite);
  Patched result{make_patches(mesh.triangles, mesh.positions, holes, flatness), mesh};
  std::size_t closed = 0;
  for (const Patch& patch : result.patches) {
    closed += patch.holes.size();
    result.mesh.triangles.insert(result.mesh.triangles.end(), patch.triangles.begin(),
                                 patch.triangles.end());
  }
  EXPECT_EQ(closed, holes.size());
  EXPECT_TRUE(build_topology(result.mesh.triangles, points).closed());
  return result;
}

// A square of n sides a side, from (0, 0) to (size, size), as a wall of height 1 turned outwards,
// or inwards.
Mesh wall(double low, double high, Index n, bool inwards) {
  Mesh mesh;
  for (const double z : {0.0, 1.0}) {
    for (int side = 0; side < 4; ++side) {
      for (Index i = 0; i < n; ++i) {
        const double at = low + (high - low) * i / n;
        const double back = low + (high - low) * (n - i) / n;
        const double x[] = {at, high, back, low};
        const double y[] = {low, at, high, back};
        mesh.positions.emplace_back(x[side], y[side], z);
      }
    }
  }
  const Index round = 4 * n;
  for (Index i = 0; i < round; ++i) {
    const Index j = (i + 1) % round;
    mesh.triangles.push_back({i, j, round + j});
    mesh.triangles.push_back({i, round + j, round + i});
  }
  return inwards ? shapes::inverted(mesh) : mesh;
}

TEST(Patches, AWallGetsTwoFlatOnes) {
  const Patched result = patched(wall(0, 2, 16, false));
  ASSERT_EQ(result.patches.size(), 2u);
  for (const Patch& patch : result.patches) {
    EXPECT_NEAR(patch.area, 4, 1e-12);
    EXPECT_FALSE(patch.narrow);
    EXPECT_EQ(patch.triangles.size(), 62u);
    EXPECT_NEAR(std::abs(patch.normal.z()), 1, 1e-12);
    EXPECT_EQ(patch.normal.z() > 0, patch.point.z() > 0.5);
  }
  const check::MeshCheck report = check::check_mesh(result.mesh);
  EXPECT_TRUE(report.two_manifold) << report.faults();
  EXPECT_NEAR(report.volume, 4, 1e-12);
}

TEST(Patches, RoundsInEachOtherGetOnePatchWithHoles) {
  const Mesh frame = shapes::merged(
      {wall(0, 8, 5, false), wall(1, 3, 3, true), wall(4, 7, 4, true), wall(5, 6, 2, false)});
  for (const double angle : {0.0, 0.7}) {
    const Patched result = patched(shapes::rotated(frame, Vec3(1, 2, 3), angle));
    // The innermost wall stands by itself.
    ASSERT_EQ(result.patches.size(), 4u);
    EXPECT_EQ(result.patches[0].holes.size(), 3u);
    EXPECT_NEAR(result.patches[0].area, 64 - 4 - 9, 1e-9);
    const check::MeshCheck report = check::check_mesh(result.mesh);
    EXPECT_TRUE(report.two_manifold) << report.faults();
    EXPECT_NEAR(report.volume, 64 - 4 - 9 + 1, 1e-9);
  }
}

TEST(Patches, RoundsThatRunTheSameWayGetTheirOwn) {
  const Patched result = patched(shapes::merged({wall(0, 8, 5, false), wall(1, 3, 3, false)}));
  EXPECT_EQ(result.patches.size(), 4u);
  EXPECT_NEAR(check::check_mesh(result.mesh).volume, 64 + 4, 1e-9);
}

TEST(Patches, WhatIsNotFlatGetsThatOfLeastArea) {
  // The cap of a ball is cut off along edges that do not lie in one plane.
  Mesh ball = shapes::icosphere(3);
  std::erase_if(ball.triangles, [&](const Triangle& t) {
    return ball.positions[t[0]].z() > 0.8 && ball.positions[t[0]].x() < 0.5;
  });
  const Patched result = patched(ball);
  ASSERT_EQ(result.patches.size(), 1u);
  EXPECT_EQ(result.patches[0].normal, Vec3(Vec3::Zero()));
  EXPECT_TRUE(check::check_mesh(result.mesh).two_manifold);
}

TEST(Patches, CracksGetNarrowOnes) {
  Mesh slit = shapes::cube();
  // The last face's corner is moved away from the corner of its neighbours by little.
  slit.positions.push_back(slit.positions[slit.triangles.back()[0]] + Vec3(1e-4, 0, 0));
  slit.triangles.back()[0] = static_cast<Index>(slit.positions.size() - 1);
  const Patched result = patched(slit);
  ASSERT_EQ(result.patches.size(), 1u);
  EXPECT_TRUE(result.patches[0].narrow);
  EXPECT_EQ(result.patches[0].normal, Vec3(Vec3::Zero()));
}

// Ten thousand rounds, in each other or beside each other, do not take the square of that.
TEST(Patches, ManyRoundsTakeNoLongTime) {
  std::vector<Mesh> nested;
  std::vector<Mesh> beside;
  const int rounds = check::kSanitized ? 1500 : 5000;
  for (int i = 0; i < rounds; ++i) {
    nested.push_back(wall(i, 20000 - i, 1, i % 2 == 1));
    beside.push_back(wall(3 * i + 1, 3 * i + 2, 1, true));
  }
  beside.push_back(wall(0, 20000, 1, false));
  patched(shapes::merged(nested));
  patched(shapes::merged(beside));
}

TEST(Patches, OneLargeRoundTakesNoLongTime) {
  patched(wall(0, 1, check::kSanitized ? 3000 : 25000, false));
}

}  // namespace
}  // namespace kdm
