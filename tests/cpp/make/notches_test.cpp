// SPDX-License-Identifier: MIT
// Notches: blocks that are turned inwards and taken off a larger one, some of their sides on its
// sides. Nothing is left between faces on each other, and nothing is lost there.
#include <gtest/gtest.h>

#include <string>

#include "kdmanifold/kdmanifold.h"
#include "support/mesh_assert.h"
#include "support/shapes.h"

namespace kdm {
namespace {

struct Notch {
  const char* name;
  Vec3 min;
  Vec3 max;
  int genus;
};

// Of the block from the origin to (4, 4, 2).
const Notch kNotches[] = {
    {"in one side", {2.5, 1, 0.5}, {4, 3, 1.5}, 0},
    {"through two sides", {2.5, 1, 0}, {4, 3, 2}, 0},
    {"a hole", {1, 1, 0}, {3, 3, 2}, 1},
    {"a corner", {2.5, 2.5, 1}, {4, 4, 2}, 0},
};

const Vec3 kBlock(4, 4, 2);

Mesh with_notch(const Notch& notch, bool turned) {
  Mesh block = shapes::subdivided(shapes::box(Vec3::Zero(), kBlock));
  Mesh mesh = shapes::merged({block, shapes::inverted(shapes::box(notch.min, notch.max))});
  return turned ? shapes::rotated(mesh, Vec3(1, 2, 3), 0.7) : mesh;
}

TEST(Notches, AreTakenOffAndLeaveNothing) {
  for (const Notch& notch : kNotches) {
    for (const bool turned : {false, true}) {
      SCOPED_TRACE(std::string(notch.name) + (turned ? ", turned" : ""));
      const Mesh mesh = with_notch(notch, turned);
      MakeOptions options;
      options.build.relative_tolerance = 0.002;
      const MadeManifold made = make_manifold(mesh, options);
      EXPECT_EQ(made.grid.input().turned_parts, 0u);
      EXPECT_TRUE(check::is_two_manifold(static_cast<const ExtractedMesh&>(made)));
      EXPECT_EQ(made.report.crossings.value_or(1), 0u);
      const check::MeshCheck result = check::check_mesh(static_cast<const Mesh&>(made));
      EXPECT_EQ(result.components, 1);
      EXPECT_EQ(result.euler_characteristic, 2 - 2 * notch.genus);
      const double volume = kBlock.prod() - (notch.max - notch.min).prod();
      EXPECT_NEAR(result.volume, volume, 1e-3 * volume);
      const Account account = compare(mesh, made.grid, made, {});
      EXPECT_EQ(account.lost.parts, 0u);
      EXPECT_LT(made.stats.leaves, 20000u);
    }
  }
}

// What has a wall that is as thin as the tolerance is no notch: the wall stays.
TEST(Notches, KeepAThinWall) {
  for (const bool turned : {false, true}) {
    SCOPED_TRACE(turned);
    const Mesh mesh = with_notch({"beside a wall", {2.5, 1, 0.5}, {3.99, 3, 1.5}, 0}, turned);
    MakeOptions options;
    options.build.tolerance = 0.01;
    const MadeManifold made = make_manifold(mesh, options);
    const check::MeshCheck result = check::check_mesh(static_cast<const Mesh&>(made));
    EXPECT_EQ(result.components, 2);
    EXPECT_EQ(result.euler_characteristic, 4);
    EXPECT_EQ(compare(mesh, made.grid, made, {}).lost.parts, 0u);
  }
}

}  // namespace
}  // namespace kdm
