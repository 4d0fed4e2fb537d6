// SPDX-License-Identifier: MIT
// Boolean operations on whole meshes: volumes and topology that are known, identities to the byte,
// and random expressions that points decide.
#include "kdmanifold/boolean.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <cmath>
#include "kdmanifold/error.h"
#include "kdmanifold/grid_io.h"
#include "support/mesh_assert.h"
#include "support/random.h"
#include "support/sanitized.h"
#include "support/shapes.h"
#include "support/solid_check.h"

namespace kdm {
namespace {

using shapes::box;

Transform moved(const Vec3& by) {
  Transform transform = Transform::Identity();
  transform.col(3) = by;
  return transform;
}

struct Expected {
  double volume;
  int components;
  int euler;
};

// The result is a sound solid of the volume and topology: exactly as the operands lie if it is the
// grid's own, otherwise and if they are turned, so that no face is parallel to the grid, within the
// tolerance.
void expect_result(const Expression& expression, const std::vector<Mesh>& meshes,
                   const Expected& expected) {
  for (const bool turn : {false, true}) {
    for (const bool reduce : {false, true}) {
      SCOPED_TRACE(std::string(turn ? "turned" : "as it lies") + (reduce ? ", reduced" : ""));
      std::vector<Mesh> posed;
      for (const Mesh& mesh : meshes) posed.push_back(turn ? shapes::turned(mesh) : mesh);
      const BooleanMesh result =
          boolean(expression, {posed.begin(), posed.end()}, {}, {.strict = Strict::kManifold},
                  {.reduce = reduce, .target_triangles = {}});
      EXPECT_TRUE(check::is_two_manifold(result));
      EXPECT_EQ(result.report.crossings.value_or(0), 0u);
      const check::MeshCheck report = check::check_mesh(result);
      const double share = turn ? 2e-3 : reduce ? 3e-4 : 1e-9;
      EXPECT_NEAR(report.volume, expected.volume, share * expected.volume);
      EXPECT_EQ(report.components, expected.components);
      EXPECT_EQ(report.euler_characteristic, expected.euler);
      EXPECT_LT(result.triangles.size(), reduce ? 250u : turn ? 1500u : 200u);
    }
  }
}

bool same_bytes(const Mesh& a, const Mesh& b) {
  return a.positions == b.positions && a.triangles == b.triangles;
}

const Mesh kBlock = box(Vec3(0, 0, 0), Vec3(2, 2, 2));

TEST(Boolean, BoxesThatCrossHaveTheirVolumes) {
  const Mesh other = box(Vec3(1, 1, 1), Vec3(3, 3, 3));
  expect_result(union_of(0, 1), {kBlock, other}, {15, 1, 2});
  expect_result(intersection(0, 1), {kBlock, other}, {1, 1, 2});
  expect_result(difference(0, 1), {kBlock, other}, {7, 1, 2});
}

TEST(Boolean, AHoleThroughABlockIsAHandle) {
  const Mesh bar = box(Vec3(0.5, 0.5, -1), Vec3(1.5, 1.5, 3));
  expect_result(difference(0, 1), {kBlock, bar}, {6, 1, 0});
  expect_result(union_of(0, 1), {kBlock, bar}, {10, 1, 2});
  expect_result(difference(1, 0), {kBlock, bar}, {2, 2, 4});
}

TEST(Boolean, FacesOnFacesLeaveNothingBehind) {
  const Mesh beside = box(Vec3(2, 0, 0), Vec3(4, 2, 2));
  expect_result(union_of(0, 1), {kBlock, beside}, {16, 1, 2});
  expect_result(difference(0, 1), {kBlock, beside}, {8, 1, 2});
  // Faces that look the same way: a pocket that is open above, and one over the whole width.
  expect_result(difference(0, 1), {kBlock, box(Vec3(0.5, 0.5, 1), Vec3(1.5, 1.5, 2))}, {7, 1, 2});
  expect_result(difference(0, 1), {kBlock, box(Vec3(0, 0.5, 1), Vec3(2, 1.5, 2))}, {6, 1, 2});
  expect_result(intersection(0, 1), {kBlock, box(Vec3(0, 0, 1), Vec3(2, 2, 3))}, {4, 1, 2});
  expect_result(union_of(0, 1), {kBlock, box(Vec3(0, 0, 1), Vec3(2, 2, 3))}, {12, 1, 2});
  // Partly: two boxes beside each other, one of them shifted and larger.
  expect_result(union_of(0, 1), {kBlock, box(Vec3(2, 1, 1), Vec3(3, 3, 3))}, {12, 1, 2});
}

TEST(Boolean, PrismsFaceToFaceAreOne) {
  const Mesh prism = shapes::cylinder(1, 2, 7);
  const double area = check::check_mesh(prism).volume / 2;
  const Mesh above = shapes::translated(prism, Vec3(0, 0, 2));
  expect_result(union_of(0, 1), {prism, above}, {4 * area, 1, 2});
  const Mesh half = shapes::translated(prism, Vec3(0, 0, 1));
  expect_result(difference(0, 1), {prism, half}, {area, 1, 2});
  expect_result(union_of(0, 1), {prism, half}, {3 * area, 1, 2});
}

TEST(Boolean, ThreeOperandsNest) {
  const Mesh bar = box(Vec3(0.5, 0.5, -1), Vec3(1.5, 1.5, 3));
  const Mesh cross = box(Vec3(-1, 0.75, 0.75), Vec3(3, 1.25, 1.25));
  // A block with a hole, and a bar across it.
  expect_result(union_of(difference(0, 1), 2), {kBlock, bar, cross}, {6.75, 1, -2});
  expect_result(difference(0, union_of(1, 2)), {kBlock, bar, cross}, {5.75, 1, -4});
}

TEST(Boolean, ASymmetricDifferenceLeavesOutWhatIsCommon) {
  const Mesh other = box(Vec3(1, 1, 1), Vec3(3, 3, 3));
  const std::vector<Mesh> meshes{kBlock, other};
  const BooleanMesh result = boolean(symmetric_difference(0, 1), {meshes.begin(), meshes.end()});
  EXPECT_TRUE(check::is_two_manifold(result));
  EXPECT_NEAR(check::check_mesh(result).volume, 14, 0.02);
}

TEST(Boolean, AComplementIsTakenInTheBoxOfAllOperands) {
  const Mesh ball = shapes::icosphere(2, 1);
  const Mesh inner = shapes::scaled(ball, Vec3(0.5, 0.5, 0.5));
  const double volume = check::check_mesh(inner).volume;
  const Mesh room = box(Vec3(-1, -1, -1), Vec3(1, 1, 1));
  const BooleanMesh result = boolean(complement(intersection(0, 1)), {room, inner});
  EXPECT_TRUE(check::is_two_manifold(result));
  const check::MeshCheck report = check::check_mesh(result);
  EXPECT_NEAR(report.volume, 8 - volume, 0.01);
  EXPECT_EQ(report.components, 2);
  std::size_t of_box = 0;
  for (const Index operand : result.source_operands) of_box += operand == kNone ? 1 : 0;
  EXPECT_GE(of_box, 12u);
  EXPECT_LT(of_box, result.triangles.size());
}

TEST(Boolean, IdentitiesHoldToTheByte) {
  const Mesh a = shapes::icosphere(3, 1);
  const Mesh b = shapes::translated(shapes::torus(1, 0.3, 24, 12), Vec3(0.5, 0.1, 0.2));
  const Mesh c = shapes::turned(shapes::cylinder(0.4, 3, 9));
  const auto result = [](const Expression& expression, const std::vector<Operand>& operands) {
    return boolean(expression, operands, {.relative_tolerance = 0.005});
  };
  EXPECT_TRUE(
      same_bytes(result(difference(0, 1), {a, b}), result(intersection(0, complement(1)), {a, b})));
  EXPECT_TRUE(
      same_bytes(result(union_of({0, 1, 2}), {a, b, c}), result(union_of({2, 0, 1}), {a, b, c})));
  EXPECT_TRUE(
      same_bytes(result(union_of({0, 1, 2}), {a, b, c}), result(union_of({0, 1, 2}), {c, a, b})));
  EXPECT_TRUE(same_bytes(result(union_of(0, 1), {a, a}), result(0, {a})));
  EXPECT_TRUE(same_bytes(result(intersection(0, 1), {a, a}), result(0, {a})));
  EXPECT_TRUE(same_bytes(result(difference(0, symmetric_difference(0, 1)), {a, b}),
                         result(intersection(0, 1), {a, b})));
  const BuildOptions build = {.relative_tolerance = 0.005};
  EXPECT_TRUE(same_bytes(boolean(0, {a}, build, {}, {.reduce = false, .target_triangles = {}}),
                         extract(build_grid(a, build))));
}

TEST(Boolean, ResultsAreReducedWithinTheTolerance) {
  const Mesh ball = shapes::icosphere(4, 1);
  const Mesh ring = shapes::translated(shapes::torus(1, 0.3, 64, 32), Vec3(0.5, 0.1, 0.2));
  const BuildOptions build = {.relative_tolerance = 0.005};
  const BooleanMesh few = boolean(difference(0, 1), {ball, ring}, build);
  const BooleanMesh own =
      boolean(difference(0, 1), {ball, ring}, build, {.strict = Strict::kEmbedded},
              {.reduce = false, .target_triangles = {}});
  EXPECT_FALSE(own.reduced);
  ASSERT_TRUE(few.reduced);
  EXPECT_LT(few.triangles.size(), own.triangles.size() / 2);
  EXPECT_TRUE(check::is_two_manifold(few));
  EXPECT_EQ(find_self_intersections(few).pairs, 0u);
  const check::MeshCheck of_few = check::check_mesh(few);
  const check::MeshCheck of_own = check::check_mesh(own);
  EXPECT_NEAR(of_few.volume, of_own.volume, 0.02 * of_own.volume);
  EXPECT_EQ(of_few.components, of_own.components);
  EXPECT_EQ(of_few.euler_characteristic, of_own.euler_characteristic);
  EXPECT_DOUBLE_EQ(few.stats.tolerance, few.stats.asked_tolerance);
  // Every triangle names an operand that is near to its middle.
  ASSERT_EQ(few.source_operands.size(), few.triangles.size());
  for (std::size_t t = 0; t < few.triangles.size(); ++t) {
    const Triangle& c = few.triangles[t];
    const Vec3 middle = (few.positions[c[0]] + few.positions[c[1]] + few.positions[c[2]]) / 3;
    ASSERT_LT(few.source_operands[t], 2u);
    EXPECT_FALSE(check::clear_of(few.source_operands[t] == 0 ? ball : ring, middle,
                                 2 * few.stats.tolerance));
  }
  const BooleanMesh levels = boolean(difference(0, 1), {ball, ring}, {.relative_tolerance = 0.02},
                                     {}, {.reduce = {}, .target_triangles = {900, 600}});
  ASSERT_EQ(levels.levels.size(), 2u);
  EXPECT_LE(levels.levels[0].triangles.size(), 900u);
  EXPECT_LE(levels.levels[1].triangles.size(), 600u);
}

TEST(Boolean, EveryFaceKnowsItsOperandAndItsFace) {
  const Mesh other = box(Vec3(1, 1, 1), Vec3(3, 3, 3));
  const BooleanMesh result = boolean(difference(1, 0), {other, kBlock});
  ASSERT_EQ(result.source_operands.size(), result.triangles.size());
  ASSERT_EQ(result.source_faces.size(), result.triangles.size());
  const std::array<const Mesh*, 2> meshes{&other, &kBlock};
  for (std::size_t t = 0; t < result.triangles.size(); ++t) {
    ASSERT_LT(result.source_operands[t], 2u);
    const Mesh& mesh = *meshes[result.source_operands[t]];
    const Triangle& face = mesh.triangles[result.source_faces[t]];
    const Vec3& a = mesh.positions[face[0]];
    const Vec3 normal = (mesh.positions[face[1]] - a).cross(mesh.positions[face[2]] - a);
    for (const Index v : result.triangles[t]) {
      EXPECT_LT(std::abs(normal.normalized().dot(result.positions[v] - a)), 1e-3);
    }
  }
}

TEST(Boolean, TransformsPlaceAndMirrorOperands) {
  const Mesh cube = shapes::cube();
  const BooleanMesh moved_apart = boolean(union_of(0, 1), {cube, {cube, moved(Vec3(3, 0, 0))}});
  EXPECT_NEAR(check::check_mesh(moved_apart).volume, 2, 1e-5);
  EXPECT_EQ(check::check_mesh(moved_apart).components, 2);
  Transform mirror = Transform::Identity();
  mirror(0, 0) = -1;
  for (const InsideRule rule : {InsideRule::kRepair, InsideRule::kPositive}) {
    const BooleanMesh mirrored = boolean(union_of(0, 1), {cube, {cube, mirror}}, {.inside = rule});
    EXPECT_TRUE(check::is_two_manifold(mirrored));
    EXPECT_NEAR(check::check_mesh(mirrored).volume, 2, 1e-5);
    EXPECT_EQ(check::check_mesh(mirrored).components, 1);
  }
}

TEST(Boolean, OperandsMayBeBroken) {
  const Mesh ball = shapes::icosphere(3, 1);
  const double volume = check::check_mesh(ball).volume;
  const Mesh bar = box(Vec3(-0.3, -0.3, -2), Vec3(0.3, 0.3, 2));
  const double rest = check::check_mesh(boolean(difference(0, 1), {ball, bar})).volume;
  EXPECT_LT(rest, volume - 0.5);
  const Mesh doubled = shapes::merged({ball, ball});
  const Mesh open = shapes::open(ball, 6);
  const Mesh inverted = shapes::inverted(ball);
  const Mesh soup = shapes::soup(ball);
  for (const Mesh* broken : {&doubled, &open, &inverted, &soup}) {
    const BooleanMesh result = boolean(difference(0, 1), {*broken, bar});
    EXPECT_TRUE(check::is_two_manifold(result));
    EXPECT_NEAR(check::check_mesh(result).volume, rest, 0.02);
    ASSERT_EQ(result.operands.size(), 2u);
    EXPECT_EQ(result.operands[1].triangles, 12u);
    EXPECT_EQ(result.operands[0].triangles, broken->triangles.size());
  }
  EXPECT_FALSE(boolean(difference(0, 1), {open, bar}).operands[0].closed);
  // Scraps that only winding numbers close, whatever the options are.
  std::vector<Mesh> scraps;
  const Mesh coarse = shapes::icosphere(1, 1);
  for (const Triangle& t : coarse.triangles) {
    Mesh scrap;
    scrap.positions = coarse.positions;
    scrap.triangles = {t};
    const double by = scraps.size() % 2 == 0 ? 0.1 : 0;
    scraps.push_back(shapes::translated(scrap, by * coarse.positions[t[0]]));
  }
  for (const SplitStrategy strategy : {SplitStrategy::kAdaptive, SplitStrategy::kUniform}) {
    if (check::kSanitized && strategy == SplitStrategy::kAdaptive) continue;
    BuildOptions build{.strategy = strategy};
    if (strategy == SplitStrategy::kAdaptive) build.relative_tolerance = 0.0008;
    const BooleanMesh result = boolean(difference(0, 1), {shapes::merged(scraps), bar}, build);
    EXPECT_TRUE(check::is_two_manifold(result));
    EXPECT_GT(check::check_mesh(result).volume, 0.8 * rest);
    EXPECT_GT(result.operands[0].rebuilt_parts, 40u);
  }
  EXPECT_TRUE(boolean(difference(0, 1), {inverted, bar}).operands[0].flipped);
}

TEST(Boolean, ASavedGridKeepsItsOperands) {
  const Mesh open = shapes::open(shapes::icosphere(2, 1), 3);
  const Grid grid = build_csg_grid({open, kBlock}, complement(difference(0, 1)));
  const Grid loaded = load_grid(save_grid(grid));
  EXPECT_EQ(save_grid(loaded), save_grid(grid));
  const ExtractedMesh a = extract(grid);
  const ExtractedMesh b = extract(loaded);
  EXPECT_TRUE(same_bytes(a, b));
  EXPECT_EQ(a.source_operands, b.source_operands);
  EXPECT_EQ(std::count(a.source_operands.begin(), a.source_operands.end(), kNone) > 0, true);
  ASSERT_EQ(loaded.operands().size(), 2u);
  EXPECT_FALSE(loaded.operands()[0].closed);
  EXPECT_EQ(loaded.operands()[0].patched_holes, grid.operands()[0].patched_holes);
  EXPECT_EQ(loaded.operands()[1].triangles, 12u);
}

// Calls and returns the message of the error with this code.
template <typename Call>
std::string message_of(ErrorCode code, const Call& call) {
  try {
    call();
  } catch (const Error& error) {
    EXPECT_EQ(error_code_name(error.code()), std::string(error_code_name(code)));
    return error.what();
  }
  ADD_FAILURE() << "no error";
  return {};
}

TEST(Boolean, ErrorsSayWhatIsWrong) {
  const Mesh cube = shapes::cube();
  const Mesh empty;
  EXPECT_NE(message_of(ErrorCode::kEmptyResult,
                       [&] {
                         boolean(difference(0, 1), {cube, cube});
                       })
                .find("leaves nothing"),
            std::string::npos);
  EXPECT_NE(message_of(ErrorCode::kInvalidOption,
                       [&] {
                         boolean(union_of(0, 2), {cube, cube});
                       })
                .find("names operand 2"),
            std::string::npos);
  Transform flat = Transform::Identity();
  flat(2, 2) = 0;
  EXPECT_EQ(message_of(ErrorCode::kInvalidOption,
                       [&] {
                         boolean(union_of(0, 1), {cube, {cube, flat}});
                       })
                .rfind("operand 1: transform", 0),
            0u);
  flat(2, 2) = std::nan("");
  EXPECT_EQ(message_of(ErrorCode::kInvalidOption,
                       [&] {
                         boolean(union_of(0, 1), {{cube, flat}, cube});
                       })
                .rfind("operand 0: transform", 0),
            0u);
  EXPECT_EQ(message_of(ErrorCode::kInvalidMesh,
                       [&] {
                         boolean(union_of(0, 1), {cube, empty});
                       }),
            "operand 1: the mesh has no vertices");
  EXPECT_EQ(message_of(ErrorCode::kInvalidOption,
                       [&] { boolean(0, {cube}, {.inside = InsideRule::kSheet}); })
                .rfind("operand 0: inside", 0),
            0u);
}

// --- Random expressions -----------------------------------------------------------------------

// An expression, and the same as a function.
struct Tree {
  Expression expression;
  std::function<bool(const std::vector<bool>&)> value;
};

Tree random_tree(check::Random& random, Index operands, int depth) {
  if (depth == 0 || random.below(5) == 0) {
    const Index k = random.below(operands);
    return {k, [k](const std::vector<bool>& in) { return in[k]; }};
  }
  const Tree a = random_tree(random, operands, depth - 1);
  const Tree b = random_tree(random, operands, depth - 1);
  switch (random.below(4)) {
    case 0:
      return {union_of(a.expression, b.expression),
              [a, b](const std::vector<bool>& in) { return a.value(in) || b.value(in); }};
    case 1:
      return {intersection(a.expression, b.expression),
              [a, b](const std::vector<bool>& in) { return a.value(in) && b.value(in); }};
    case 2:
      return {difference(a.expression, b.expression),
              [a, b](const std::vector<bool>& in) { return a.value(in) && !b.value(in); }};
    default:
      return {symmetric_difference(a.expression, b.expression),
              [a, b](const std::vector<bool>& in) { return a.value(in) != b.value(in); }};
  }
}

Mesh random_solid(check::Random& random) {
  const auto number = [&](double least, double most) {
    return least + (most - least) * random.below(1u << 20) / (1u << 20);
  };
  // Every other one on a coarse raster, so that faces coincide.
  const bool raster = random.below(2) == 0;
  const auto corner = [&] { return 0.25 * random.below(5); };
  if (raster) {
    const Vec3 low(corner(), corner(), corner());
    return box(low, low + Vec3(0.25 + corner(), 0.25 + corner(), 0.25 + corner()));
  }
  const Vec3 at(number(0, 1), number(0, 1), number(0, 1));
  Mesh mesh = random.below(2) == 0
                  ? shapes::cylinder(number(0.2, 0.6), number(0.3, 1.5), 3 + random.below(6))
                  : shapes::icosphere(1, number(0.3, 0.7));
  mesh = shapes::rotated(mesh, Vec3(number(-1, 1), number(-1, 1), 1).normalized(), number(0, 3));
  return shapes::translated(mesh, at);
}

TEST(Boolean, RandomExpressionsHoldAtAllPoints) {
  int results = 0;
  int compared = 0;
  for (std::uint32_t seed = 1; seed <= (check::kSanitized ? 60 : 300); ++seed) {
    SCOPED_TRACE(seed);
    check::Random random(seed);
    std::vector<Mesh> meshes;
    const Index count = 2 + random.below(3);
    for (Index i = 0; i < count; ++i) meshes.push_back(random_solid(random));
    const Tree tree = random_tree(random, count, 2);
    Mesh result;
    try {
      result =
          boolean(tree.expression, {meshes.begin(), meshes.end()}, {.relative_tolerance = 0.005});
      ++results;
      EXPECT_TRUE(check::is_two_manifold(result));
      EXPECT_EQ(find_self_intersections(result).pairs, 0u);
    } catch (const Error& error) {
      EXPECT_EQ(error_code_name(error.code()), std::string("EMPTY_RESULT")) << error.what();
    }
    const Mesh all = shapes::merged(meshes);
    for (int i = 0; i < 40; ++i) {
      const auto coordinate = [&] { return 3.0 * random.below(1u << 20) / (1u << 20) - 0.75; };
      const Vec3 point(coordinate(), coordinate(), coordinate());
      if (!check::clear_of(all, point, 0.03)) continue;
      std::vector<bool> in;
      for (const Mesh& mesh : meshes) in.push_back(check::winding_number(mesh, point) > 0);
      EXPECT_EQ(check::winding_number(result, point), tree.value(in) ? 1 : 0) << point.transpose();
      ++compared;
    }
  }
  EXPECT_GT(results, check::kSanitized ? 40 : 200);
  EXPECT_GT(compared, check::kSanitized ? 1000 : 5000);
}

// Where surfaces cross, the pieces in a cell bound disks together: that is proven for solids in
// general position, so that nothing has to be taken back.
TEST(Boolean, TheTopologyOfSolidsInGeneralPositionIsResolved) {
  const Mesh ball = shapes::icosphere(4, 1.0);
  const Mesh other = shapes::translated(shapes::icosphere(3, 0.8), Vec3(0.71, 0.33, 0.21));
  const Mesh cube = shapes::turned(box(Vec3(0.1, 0.1, 0.1), Vec3(1.2, 1.3, 1.4)));
  for (const Mesh& second : {other, cube}) {
    for (const Expression& expression :
         {union_of(0, 1), intersection(0, 1), difference(0, 1), difference(1, 0)}) {
      const Grid grid = build_csg_grid({ball, second}, expression, {.relative_tolerance = 0.002});
      EXPECT_TRUE(grid.stats().topology_resolved);
      const check::MeshCheck result = check::check_mesh(extract(grid));
      EXPECT_TRUE(result.two_manifold) << result.faults();
      EXPECT_EQ(result.components, 1);
      EXPECT_EQ(result.euler_characteristic, 2);
    }
  }
}

// Each of the pillar's edges pierces the plate twice.
TEST(Boolean, ATurnedPillarThroughAPlateIsResolved) {
  const Mesh plate = shapes::turned(box(Vec3(-1, -1, -0.1), Vec3(1, 1, 0.1)));
  const Mesh pillar = shapes::turned(box(Vec3(-0.2, -0.3, -1), Vec3(0.3, 0.2, 1)));
  EXPECT_TRUE(build_csg_grid({plate, pillar}, union_of(0, 1)).stats().topology_resolved);
  EXPECT_TRUE(build_csg_grid({plate, pillar}, intersection(0, 1)).stats().topology_resolved);
}

// With all four sheets of a crossing the boundary is no disk, and nothing is claimed.
TEST(Boolean, TheTopologyOfASymmetricDifferenceIsNotClaimed) {
  const Mesh ball = shapes::icosphere(3, 1.0);
  const Mesh other = shapes::translated(ball, Vec3(0.7, 0.3, 0.2));
  EXPECT_FALSE(build_csg_grid({ball, other}, symmetric_difference(0, 1)).stats().topology_resolved);
}

}  // namespace
}  // namespace kdm
