// SPDX-License-Identifier: MIT
// Solids that are moved: every result is that of a new operation, to the byte.
#include "kdmanifold/boolean_scene.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "kdmanifold/error.h"
#include "support/grid_compare.h"
#include "support/random.h"
#include "support/sanitized.h"
#include "support/shapes.h"

namespace kdm {
namespace {

const Mesh& large() {
  static const Mesh mesh = shapes::scaled(shapes::torus(1, 0.4, 80, 40), Vec3(1, 1, 3));
  return mesh;
}

const Mesh& tool() {
  static const Mesh mesh = shapes::icosphere(2, 0.3);
  return mesh;
}

Transform moved_by(double x, double y, double z) {
  Transform transform = Transform::Identity();
  transform.col(3) = Vec3(x, y, z);
  return transform;
}

// Turned, stretched, mirrored half of the time. Within a reach of 0.6 it stays in the box of the
// large one.
Transform random_place(check::Random& random, double reach) {
  Transform place;
  const double angle = random.between(0, 3);
  const Vec3 axis = random.direction();
  const Vec3 scale(random.between(0.5, 1.2), random.between(0.5, 1.2),
                   random.between(0.5, 1.2) * (random.coin() ? 1 : -1));
  place.leftCols<3>() =
      Eigen::AngleAxisd(angle, axis).toRotationMatrix() * scale.asDiagonal().toDenseMatrix();
  place.col(3) = random.point(-reach, reach);
  return place;
}

void expect_same_made(const MadeManifold& a, const MadeManifold& b) {
  check::expect_same(a.grid, b.grid);
  EXPECT_EQ(a.positions, b.positions);
  EXPECT_EQ(a.triangles, b.triangles);
  EXPECT_EQ(a.source_faces, b.source_faces);
  EXPECT_EQ(a.source_operands, b.source_operands);
  EXPECT_EQ(a.stats.unresolved_positions, b.stats.unresolved_positions);
  EXPECT_EQ(a.stats.tolerance, b.stats.tolerance);
  ASSERT_EQ(a.grid.operands().size(), b.grid.operands().size());
  for (std::size_t i = 0; i < a.grid.operands().size(); ++i) {
    EXPECT_EQ(a.grid.operands()[i].vertices, b.grid.operands()[i].vertices);
    EXPECT_EQ(a.grid.operands()[i].flipped, b.grid.operands()[i].flipped);
    EXPECT_EQ(a.grid.operands()[i].extent, b.grid.operands()[i].extent);
  }
}

struct SceneCase {
  const char* name;
  Expression expression;
  std::vector<Mesh> meshes;
  MakeOptions options;
};

Mesh crossing_balls() {
  return shapes::merged({tool(), shapes::translated(tool(), Vec3(0.2, 0.1, 0))});
}

std::vector<SceneCase> scene_cases() {
  const BuildOptions build{.relative_tolerance = 0.005};
  const ReductionOptions plain{.reduce = false};
  BuildOptions octree = build;
  octree.strategy = SplitStrategy::kOctree;
  BuildOptions feature = build;
  feature.strategy = SplitStrategy::kFeature;
  const BuildOptions uniform{.strategy = SplitStrategy::kUniform};
  const BuildOptions median{.strategy = SplitStrategy::kMedian, .depth = 12};
  const ExtractOptions embedded{.strict = Strict::kEmbedded};
  return {
      {"a difference", difference(0, 1), {large(), tool()}, {build, {}, plain}},
      {"reduced", difference(0, 1), {large(), tool()}, {build, {}, {}}},
      {"embedded", union_of(0, 1), {large(), tool()}, {build, embedded, plain}},
      {"one of three",
       symmetric_difference(difference(0, 1), 2),
       {large(), tool(), shapes::box(Vec3(-1.2, -0.2, -0.2), Vec3(1.2, 0.2, 0.2))},
       {build, {}, plain}},
      {"a complement", difference(complement(1), 0), {large(), tool()}, {build, {}, plain}},
      {"a tool with a hole",
       difference(0, 1),
       {large(), shapes::open(tool(), 3)},
       {build, {}, plain}},
      {"a large one with a hole",
       difference(0, 1),
       {shapes::open(large(), 4), tool()},
       {build, {}, plain}},
      {"a tool that crosses itself",
       union_of(0, 1),
       {large(), crossing_balls()},
       {build, {}, plain}},
      {"a large one that crosses itself",
       difference(0, 1),
       {shapes::merged({large(), shapes::rotated(large(), Vec3(1, 0, 0), 1.5)}), tool()},
       {build, {}, plain}},
      {"half a ball", difference(0, 1), {large(), shapes::open(tool(), 100)}, {build, {}, plain}},
      {"an octree", difference(0, 1), {large(), tool()}, {octree, {}, plain}},
      {"feature points", difference(0, 1), {large(), tool()}, {feature, {}, plain}},
      {"even cells", difference(0, 1), {large(), tool()}, {uniform, {}, plain}},
      {"medians", difference(0, 1), {large(), tool()}, {median, {}, plain}},
  };
}

class BooleanScenes : public testing::TestWithParam<int> {};

TEST_P(BooleanScenes, GiveTheBytesOfANewOperation) {
  const auto [name, expression, meshes, options] =
      scene_cases()[static_cast<std::size_t>(GetParam())];
  SCOPED_TRACE(name);
  check::Random random(static_cast<std::uint32_t>(GetParam()) + 1);
  std::vector<Operand> operands(meshes.begin(), meshes.end());
  BooleanScene scene(expression, operands, options);
  for (int i = 0; i < (check::kSanitized ? 2 : 8); ++i) {
    SCOPED_TRACE(i);
    // Now and then it leaves the box, so that the lattice changes, or the other one is moved.
    const Index which = i == 5 ? 0 : 1;
    operands[which].transform =
        i == 5 ? moved_by(0.01, 0, 0) : random_place(random, i == 3 ? 1.4 : 0.6);
    scene.place(which, operands[which].transform);
    expect_same_made(scene.make_in_steps({}),
                     make_solids_in_steps(expression, operands, options, {}));
  }
}

INSTANTIATE_TEST_SUITE_P(Cases, BooleanScenes,
                         testing::Range(0, static_cast<int>(scene_cases().size())));

const MakeOptions kPlain{{.relative_tolerance = 0.01}, {}, {.reduce = false}};

BooleanMesh anew(const Transform& place) {
  return boolean(difference(0, 1), {large(), {tool(), place}}, kPlain.build, kPlain.extract,
                 kPlain.reduction);
}

void expect_same_mesh(const BooleanMesh& a, const BooleanMesh& b) {
  EXPECT_EQ(a.positions, b.positions);
  EXPECT_EQ(a.triangles, b.triangles);
  EXPECT_EQ(a.operands.size(), b.operands.size());
}

TEST(BooleanScene, GoesOnAfterItWasStopped) {
  BooleanScene scene(difference(0, 1), {large(), tool()}, kPlain);
  expect_same_mesh(scene.update(1, moved_by(1, 0, 0)), anew(moved_by(1, 0, 0)));
  // In another box, whose cells are of no use for the first one.
  for (const double last : {0.05, 0.5, 0.9}) {
    const Progress stop = [&](double fraction, std::string_view) { return fraction < last; };
    try {
      scene.update(1, moved_by(3, 0, 0), stop);
      ADD_FAILURE() << "it was not stopped at " << last;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::kAborted);
    }
    expect_same_mesh(scene.update(1, moved_by(1, 0.1, 0)), anew(moved_by(1, 0.1, 0)));
  }
}

TEST(BooleanScene, SaysWhatIsWrongAndGoesOn) {
  const auto code_of = [](const auto& work) {
    try {
      work();
    } catch (const Error& error) {
      return std::string(error_code_name(error.code())) + ": " + error.what();
    }
    return std::string("nothing");
  };
  BooleanScene scene(difference(0, 1), {large(), tool()}, kPlain);
  EXPECT_EQ(code_of([&] { scene.place(2, moved_by(0, 0, 0)); }),
            "INVALID_OPTION: operand: there is none of number 2, but 2, counted from 0");
  EXPECT_EQ(code_of([&] { scene.update(1, Transform::Zero()); }),
            "INVALID_OPTION: operand 1: transform: it is not invertible, its determinant is 0");
  expect_same_mesh(scene.update(1, moved_by(1, 0, 0)), anew(moved_by(1, 0, 0)));
  EXPECT_EQ(code_of([] {
              BooleanScene(difference(0, 2), {large(), tool()});
            }),
            "INVALID_OPTION: expression: it names operand 2, but there are 2, counted from 0");
  EXPECT_EQ(
      code_of([] {
        BooleanScene(difference(0, 1), {large(), tool()}, {{}, {.quads = true}, {.reduce = true}});
      }).substr(0, 14),
      "INVALID_OPTION");
  // Nothing is left, and then something is.
  const Mesh around = shapes::icosphere(3, 3);
  BooleanScene empty(difference(0, 1), {tool(), around}, kPlain);
  EXPECT_EQ(code_of([&] { empty.make(); }).substr(0, 12), "EMPTY_RESULT");
  EXPECT_FALSE(empty.update(0, moved_by(2.9, 0, 0)).triangles.empty());
}

}  // namespace
}  // namespace kdm
