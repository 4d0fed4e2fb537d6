// SPDX-License-Identifier: MIT
// Thin parts of the operands of Boolean operations: where they bound the result all over, they
// stand in it as they are.
#include <gtest/gtest.h>

#include "grid/validate.h"
#include "kdmanifold/kdmanifold.h"
#include "support/grid_compare.h"
#include "support/mesh_assert.h"
#include "support/shapes.h"

namespace kdm {
namespace {

constexpr double kTolerance = 0.01;
constexpr double kThickness = 1.6 * kTolerance;

Mesh plate(const Vec3& at) {
  const Mesh flat = shapes::box(Vec3(-0.3, -0.3, -kThickness / 2), Vec3(0.3, 0.3, kThickness / 2));
  return shapes::translated(shapes::rotated(flat, Vec3(1, 2, 3), 0.7), at);
}

constexpr double kVolume = 0.6 * 0.6 * kThickness;

struct Made {
  Grid grid;
  ExtractedMesh mesh;
  double volume;
};

Made make(const std::vector<Operand>& operands, const Expression& expression) {
  Made made{build_csg_grid(operands, expression, {.tolerance = kTolerance}), {}, 0};
  EXPECT_NO_THROW(validate(made.grid.data()));
  check::expect_same(load_grid(save_grid(made.grid)), made.grid);
  made.mesh = extract(made.grid);
  EXPECT_TRUE(check::is_two_manifold(made.mesh));
  EXPECT_EQ(made.mesh.report.crossings, 0u);
  EXPECT_EQ(made.mesh.source_operands.size(), made.mesh.triangles.size());
  made.volume = check::check_mesh(made.mesh).volume;
  return made;
}

TEST(ExactOperands, BesideOthersAreTaken) {
  const Mesh cube = shapes::cube();
  const Mesh thin = plate(Vec3(3, 0, 0));
  for (const bool first : {false, true}) {
    const std::vector<Operand> operands =
        first ? std::vector<Operand>{thin, cube} : std::vector<Operand>{cube, thin};
    const Made made = make(operands, union_of(0, 1));
    EXPECT_EQ(made.grid.stats().exact_parts, 1u);
    EXPECT_NEAR(made.volume, 1 + kVolume, 1e-5);
    std::size_t of_plate = 0;
    for (const Index operand : made.mesh.source_operands) of_plate += operand == (first ? 0 : 1);
    EXPECT_EQ(of_plate, thin.triangles.size());
  }
  EXPECT_EQ(make({thin, cube}, difference(0, 1)).grid.stats().exact_parts, 1u);
  EXPECT_EQ(make({thin}, Expression(0)).grid.stats().exact_parts, 1u);
}

TEST(ExactOperands, WithinOthersAreTakenWhereTheyBoundTheResult) {
  const Mesh cube = shapes::cube();
  const Mesh thin = plate(Vec3::Constant(0.5));
  Made made = make({cube, thin}, intersection(0, 1));
  EXPECT_EQ(made.grid.stats().exact_parts, 1u);
  EXPECT_EQ(made.grid.stats().hits, 0u) << "the cube bounds nothing";
  EXPECT_NEAR(made.volume, kVolume, 1e-5 * kVolume);
  made = make({cube, thin}, union_of(0, 1));
  EXPECT_EQ(made.grid.stats().exact_parts + made.grid.stats().thin_parts, 0u);
  EXPECT_NEAR(made.volume, 1, 1e-5);
}

TEST(ExactOperands, ThinHollowsStayInTheSurfaceAndAreTold) {
  const Mesh cube = shapes::cube();
  const Mesh thin = plate(Vec3::Constant(0.5));
  const Made made = make({cube, thin}, difference(0, 1));
  EXPECT_EQ(made.grid.stats().exact_parts, 0u);
  EXPECT_EQ(made.grid.stats().thin_parts, 1u);
  EXPECT_EQ(check::check_mesh(made.mesh).components, 2);
  EXPECT_NEAR(made.volume, 1 - kVolume, 0.25 * kVolume);
}

TEST(ExactOperands, WhatCrossesGoesThroughCells) {
  const Mesh cube = shapes::cube();
  const Mesh thin = plate(Vec3(1, 0.5, 0.5));
  const Made made = make({cube, thin}, union_of(0, 1));
  EXPECT_EQ(made.grid.stats().exact_parts, 0u);
  EXPECT_EQ(made.grid.stats().thin_parts, 1u);
  EXPECT_EQ(check::check_mesh(made.mesh).components, 1);
}

}  // namespace
}  // namespace kdm
