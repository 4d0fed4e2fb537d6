// SPDX-License-Identifier: MIT
#include "csg/solids_builder.h"

#include <gtest/gtest.h>

#include "support/grid_compare.h"
#include "support/shapes.h"

namespace kdm {
namespace {

constexpr BuildOptions kFine{.relative_tolerance = 0.002};

Transform at(double x, double y, double z) {
  Transform transform = Transform::Identity();
  transform.col(3) = Vec3(x, y, z);
  return transform;
}

TEST(SolidsBuilder, TakesOverWhatAMoveLeavesAsItIs) {
  const Mesh ring = shapes::torus(1, 0.4, 96, 48);
  const Mesh ball = shapes::icosphere(2, 0.1);
  std::vector<Operand> operands = {ring, {ball, at(0.62, 0, 0)}};
  SolidsBuilder builder(operands, difference(0, 1), kFine, SolidsBuilder::Builds::kAgain);
  const auto build = [&] {
    SolidsGrid built = builder.build(1, SolidsBuilder::Faces::kLeftOut, {});
    check::expect_same(built.grid, build_csg_grid(operands, difference(0, 1), kFine));
    return built.grid.stats().cells / 2;
  };
  build();
  EXPECT_EQ(builder.splits_taken_over(), 0u);
  operands[1].transform = at(0.65, 0.05, 0);
  builder.place(1, operands[1].transform);
  const Index splits = build();
  EXPECT_GT(builder.splits_taken_over(), splits * 3 / 4);
  // Nothing has moved at all.
  build();
  EXPECT_EQ(builder.splits_taken_over(), splits);
  // Far away from where it was, but in the same box.
  operands[1].transform = at(-0.62, -0.3, 0.1);
  builder.place(1, operands[1].transform);
  const Index all = build();
  EXPECT_LT(builder.splits_taken_over(), all);
  EXPECT_GT(builder.splits_taken_over(), all / 2);
  // The box of all grows, and with it the lattice.
  operands[1].transform = at(2, 0, 0);
  builder.place(1, operands[1].transform);
  build();
  EXPECT_EQ(builder.splits_taken_over(), 0u);
}

TEST(SolidsBuilder, ReadsTheFacesOnlyIfTheyAreWanted) {
  const Mesh ball = shapes::icosphere(2);
  SolidsBuilder builder({ball, {ball, at(0.5, 0, 0)}}, union_of(0, 1), kFine,
                        SolidsBuilder::Builds::kOnce);
  EXPECT_EQ(builder.build(1, SolidsBuilder::Faces::kToo, {}).faces.triangles.size(),
            2 * ball.triangles.size());
  SolidsBuilder again({ball, {ball, at(0.5, 0, 0)}}, union_of(0, 1), kFine,
                      SolidsBuilder::Builds::kOnce);
  EXPECT_TRUE(again.build(1, SolidsBuilder::Faces::kLeftOut, {}).faces.triangles.empty());
}

}  // namespace
}  // namespace kdm
