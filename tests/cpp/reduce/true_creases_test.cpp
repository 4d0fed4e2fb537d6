// SPDX-License-Identifier: MIT
#include "reduce/true_creases.h"

#include <gtest/gtest.h>

#include "support/shapes.h"

namespace kdm {
namespace {

TEST(TrueCreases, AreTheEdgesOfABoxAndNotItsDiagonals) {
  for (const Mesh& box : {shapes::cube(), shapes::soup(shapes::cube())}) {
    const TrueCreases creases(scaled_mesh(box, 0), 0.05);
    EXPECT_TRUE(creases.are_near(Vec3(0.5, 0, 0)));
    EXPECT_TRUE(creases.are_near(Vec3(0.5, 0.05, 0.05)));
    EXPECT_FALSE(creases.are_near(Vec3(0.5, 0.5, 0)));
    EXPECT_FALSE(creases.are_near(Vec3(0.5, 0.3, 0)));
  }
}

TEST(TrueCreases, AreNoneOnASmoothSphere) {
  const TrueCreases creases(scaled_mesh(shapes::icosphere(3), 0), 0.1);
  for (const Vec3& p : shapes::icosphere(1).positions) EXPECT_FALSE(creases.are_near(p));
}

}  // namespace
}  // namespace kdm
