// SPDX-License-Identifier: MIT
// Edges whose sides are nearly one plane come out within the tolerance, like all others.
#include <gtest/gtest.h>

#include "kdmanifold/kdmanifold.h"
#include "support/mesh_assert.h"
#include "support/random.h"
#include "support/sanitized.h"
#include "support/shapes.h"
#include "support/sheets.h"

namespace kdm {
namespace {

void expect_within(const Mesh& mesh, double tolerance) {
  const MadeManifold made = make_manifold(mesh, {.build = {.tolerance = tolerance}});
  EXPECT_TRUE(check::is_two_manifold(made));
  EXPECT_EQ(made.report.crossings, 0u);
  const Mesh many = shapes::subdivided(shapes::subdivided(shapes::subdivided(mesh)));
  EXPECT_LT(check::distance_to(many, made), 1.5 * tolerance);
  EXPECT_LT(check::distance_to(made, mesh), 1.5 * tolerance);
}

TEST(Knives, TetrahedraKeepTheirEdges) {
  check::Random random(5);
  for (int number = 0; number < (check::kSanitized ? 5 : 100); ++number) {
    SCOPED_TRACE(number);
    const auto corner = [&] {
      return Vec3(random.between(-1, 1), random.between(-1, 1), random.between(-1, 1));
    };
    const Vec3 a = corner();
    const Vec3 b = corner();
    const Vec3 c = corner();
    expect_within(shapes::tetrahedron(a, b, c, corner()), 0.008);
  }
}

}  // namespace
}  // namespace kdm
