// SPDX-License-Identifier: MIT
// Thin parts through the whole of `make_manifold`: fewer triangles, the same walls.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "kdmanifold/kdmanifold.h"
#include "support/mesh_assert.h"
#include "support/shapes.h"

namespace kdm {
namespace {

constexpr double kThinTolerance = 0.01;

// A ring of round section: a wire.
Mesh wire(double radius, int segments, int sides) {
  std::vector<std::pair<double, double>> section;
  for (int i = 0; i < sides; ++i) {
    const double angle = 2 * std::numbers::pi * i / sides;
    section.emplace_back(1 + radius * std::cos(angle), radius * std::sin(angle));
  }
  return shapes::revolved(section, segments);
}

void expect_kept(const Mesh& mesh, int parts) {
  MakeOptions options;
  options.build.tolerance = kThinTolerance;
  const MadeManifold made = make_manifold(mesh, options);
  EXPECT_EQ(made.stats.exact_parts, static_cast<Index>(parts));
  EXPECT_TRUE(check::is_two_manifold(static_cast<const ExtractedMesh&>(made)));
  EXPECT_EQ(find_self_intersections(made).pairs, 0u);
  const check::MeshCheck result = check::check_mesh(static_cast<const Mesh&>(made));
  EXPECT_EQ(result.components, parts);
  EXPECT_EQ(result.euler_characteristic, check::check_mesh(mesh).euler_characteristic);
  const double volume = shapes::signed_volume(mesh);
  EXPECT_NEAR(result.volume, volume, 0.25 * volume);
  const Account account = compare(mesh, made.grid, made, {.error = true});
  ASSERT_TRUE(account.error);
  EXPECT_LE(account.error->to_input.largest, kThinTolerance);
  EXPECT_LE(account.error->to_output.largest, kThinTolerance);
}

TEST(ThinParts, AreReducedWithTheirThickness) {
  for (const double tolerances : {0.2, 1.0, 1.6, 3.0}) {
    SCOPED_TRACE(tolerances);
    const double thickness = tolerances * kThinTolerance;
    const Mesh plate = shapes::rotated(
        shapes::subdivided(shapes::subdivided(shapes::box(Vec3(0, 0, 0), Vec3(1, 1, thickness)))),
        Vec3(1, 2, 3), 0.7);
    const Mesh rod = shapes::rotated(shapes::cylinder(thickness / 2, 2, 24), Vec3(1, 2, 3), 0.5);
    expect_kept(plate, 1);
    expect_kept(rod, 1);
    expect_kept(shapes::rotated(wire(thickness / 2, 128, 12), Vec3(3, 1, 2), 0.4), 1);
    expect_kept(shapes::merged({plate, shapes::translated(rod, Vec3(3, 0, 0))}), 2);
  }
}

}  // namespace
}  // namespace kdm
