// SPDX-License-Identifier: MIT
// What must hold of two solids however they lie to each other. `npm run figures -- DIR --section
// solids` tries the same on models.
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "kdmanifold/boolean.h"
#include "kdmanifold/error.h"
#include "support/mesh_assert.h"
#include "support/random.h"
#include "support/sanitized.h"
#include "support/shapes.h"

namespace kdm {
namespace {

constexpr double kRelativeTolerance = 0.005;

Transform random_pose(check::Random& random) {
  const double angle = random.between(0, 3);
  const Vec3 axis = random.direction();
  Transform pose;
  pose.leftCols<3>() = Eigen::AngleAxisd(angle, axis).toRotationMatrix();
  pose.col(3) = random.point(-0.3, 0.3);
  return pose;
}

double area_of_all(const Mesh& mesh) {
  double twice = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    const Vec3& p = mesh.positions[a];
    twice += (mesh.positions[b] - p).cross(mesh.positions[c] - p).norm();
  }
  return twice / 2;
}

Mesh sound(const Expression& expression, const std::vector<Operand>& operands) {
  const BooleanMesh result =
      boolean(expression, operands, {.relative_tolerance = kRelativeTolerance});
  EXPECT_TRUE(check::is_two_manifold(result));
  EXPECT_EQ(find_self_intersections(result).pairs, 0u);
  return result;
}

bool are_same(const Mesh& a, const Mesh& b) {
  return a.positions == b.positions && a.triangles == b.triangles;
}

void expect_nothing_left(const Operand& a) {
  try {
    boolean(difference(0, 1), {a, a}, {.relative_tolerance = kRelativeTolerance});
    ADD_FAILURE() << "a - a is something";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kEmptyResult) << error.what();
  }
}

class BooleanIdentities : public testing::TestWithParam<int> {};

TEST_P(BooleanIdentities, HoldInAllPoses) {
  const std::array<Mesh, 5> shapes = {
      shapes::icosphere(3, 1), shapes::torus(0.8, 0.3, 32, 16), shapes::cylinder(0.7, 1.5, 9),
      shapes::box(Vec3(-0.6, -0.5, -0.7), Vec3(0.6, 0.5, 0.7)),
      shapes::merged({shapes::icosphere(2, 0.5),
                      shapes::translated(shapes::icosphere(2, 0.6), Vec3(0.6, 0, 0))})};
  const auto which = static_cast<std::size_t>(GetParam());
  const Mesh& first = shapes[which];
  const Mesh& second = shapes[(which + 1) % shapes.size()];
  check::Random random(static_cast<std::uint32_t>(GetParam()) + 1);
  const Mesh whole_first = which == 4 ? sound(0, {first}) : first;
  const Mesh whole_second = which == 3 ? sound(0, {second}) : second;
  for (int i = 0; i < (check::kSanitized ? 1 : 8); ++i) {
    SCOPED_TRACE(i);
    const Operand a(first, random_pose(random));
    const Operand b(second, random_pose(random));
    const Mesh joined = sound(union_of(0, 1), {a, b});
    const Mesh common = sound(intersection(0, 1), {a, b});
    const double given =
        check::check_mesh(whole_first).volume + check::check_mesh(whole_second).volume;
    const double found = check::check_mesh(joined).volume + check::check_mesh(common).volume;
    const double tolerance = kRelativeTolerance * 2;  // the extent is more than 2 everywhere
    EXPECT_NEAR(found, given, 0.25 * tolerance * (area_of_all(first) + area_of_all(second)));
    // The second reaches out of the first in all poses.
    EXPECT_TRUE(
        are_same(sound(difference(1, 0), {a, b}), sound(intersection(complement(0), 1), {a, b})));
    EXPECT_TRUE(are_same(sound(intersection(0, 1), {a, a}), sound(0, {a})));
    expect_nothing_left(a);
  }
}

INSTANTIATE_TEST_SUITE_P(Shapes, BooleanIdentities, testing::Range(0, 5));

}  // namespace
}  // namespace kdm
