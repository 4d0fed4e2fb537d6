// SPDX-License-Identifier: MIT
// What comes out does not depend on the number of threads.
#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <vector>

#include "kdmanifold/boolean.h"
#include "kdmanifold/build.h"
#include "kdmanifold/error.h"
#include "kdmanifold/make_manifold.h"
#include "support/grid_compare.h"
#include "support/random_meshes.h"
#include "support/shapes.h"
#include "support/sheets.h"
#include "support/threads.h"

namespace kdm {
namespace {

// Enough triangles for cells to be made in parts.
struct Case {
  std::string name;
  Mesh mesh;
  BuildOptions options;
};

Mesh ball() { return shapes::uv_sphere(48, 25); }

Mesh many_spheres() {
  std::vector<Mesh> parts;
  for (int i = 0; i < 12; ++i) {
    parts.push_back(
        shapes::translated(shapes::icosphere(3, 0.5), Vec3(0.35 * i, 0.1 * (i % 3), 0)));
  }
  parts.push_back(parts.front());  // one twice
  return shapes::merged(parts);
}

Mesh two_spheres() {
  return shapes::merged({ball(), shapes::translated(ball(), Vec3(0.7, 0.2, 0.1))});
}

// Parts with holes that no plane closes, some of them within others, of which it must be seen where
// they look.
Mesh open_spheres() {
  std::vector<Mesh> parts;
  for (int i = 0; i < 10; ++i) {
    parts.push_back(shapes::translated(
        shapes::open(shapes::icosphere(3, 0.5 - 0.02 * i), static_cast<Index>(20 + 7 * i)),
        Vec3(0.4 * (i / 2), 0, 0)));
  }
  return shapes::merged(parts);
}

// So torn that winding numbers say what is inside.
Mesh torn_sphere() { return shapes::jittered(shapes::soup(ball()), 0.02, 7); }

std::vector<Case> cases() {
  const Mesh torus = shapes::torus(1, 0.3, 48, 24);
  std::vector<Case> all{
      {"sphere", ball(), {}},
      {"torus, octree", torus, {.strategy = SplitStrategy::kOctree, .depth = 18}},
      {"torus, feature", torus, {.strategy = SplitStrategy::kFeature, .relative_tolerance = 0.01}},
      {"torus, uniform", torus, {.strategy = SplitStrategy::kUniform, .depth = 14}},
      {"torus, median", torus, {.strategy = SplitStrategy::kMedian}},
      {"spheres that cross", many_spheres(), {.relative_tolerance = 0.005}},
      {"spheres that cross, odd",
       two_spheres(),
       {.relative_tolerance = 0.01, .inside = InsideRule::kOdd}},
      {"voxels that touch",
       shapes::turned(shapes::random_voxels(10, 0.4, 3)),
       {.relative_tolerance = 0.01}},
      {"open sphere", shapes::open(ball(), 40), {}},
      {"open spheres", open_spheres(), {.relative_tolerance = 0.02}},
      {"torn sphere", torn_sphere(), {.relative_tolerance = 0.02}},
      {"sheet",
       shapes::grid_sheet(40, 40, [](double x, double y) { return x * y; }),
       {.relative_tolerance = 0.005, .inside = InsideRule::kSheet}},
      {"opened", torus, {.relative_tolerance = 0.01, .minimum_thickness = 0.3}},
  };
  return all;
}

// Expects that a mesh is the same, made by one thread and by several.
void expect_same_meshes(const std::function<Mesh()>& make) {
  const auto make_by = [&](int threads) {
    const ThreadCount set(threads);
    return make();
  };
  const Mesh alone = make_by(1);
  for (const int threads : {2, 5, 40}) {
    const Mesh shared = make_by(threads);
    EXPECT_EQ(alone.positions, shared.positions);
    EXPECT_EQ(alone.triangles, shared.triangles);
  }
}

TEST(SameOnAnyThreads, Grids) {
  for (const Case& one : cases()) {
    SCOPED_TRACE(one.name);
    const Grid alone = [&] {
      const ThreadCount set(1);
      return build_grid(one.mesh, one.options);
    }();
    for (const int threads : {2, 5, 40}) {
      const ThreadCount set(threads);
      const Grid shared = build_grid(one.mesh, one.options);
      check::expect_same(alone, shared);
      EXPECT_EQ(alone.stats().unresolved_leaves, shared.stats().unresolved_leaves);
      EXPECT_EQ(alone.stats().unresolved_positions, shared.stats().unresolved_positions);
      EXPECT_EQ(alone.stats().topology_resolved, shared.stats().topology_resolved);
    }
  }
}

TEST(SameOnAnyThreads, ReducedMeshes) {
  for (const Case& one : cases()) {
    if (one.name != "torus, feature" && one.name != "spheres that cross" &&
        one.name != "open sphere" && one.name != "torn sphere") {
      continue;
    }
    SCOPED_TRACE(one.name);
    expect_same_meshes([&] { return make_manifold(one.mesh, {one.options, {}, {}}); });
  }
}

TEST(SameOnAnyThreads, BooleanResults) {
  const Mesh left = ball();
  const Mesh box = shapes::box(Vec3(-2, -2, 0), Vec3(3, 2, 2));
  const Mesh middle = shapes::translated(left, Vec3(0.6, 0, 0));
  const Mesh right = shapes::translated(left, Vec3(1.2, 0, 0));
  const std::vector<Operand> operands{left, middle, right, box};
  const Expression expression = difference(union_of({0, 1, 2}), 3);
  expect_same_meshes([&] { return boolean(expression, operands, {}); });
}

// Whenever the caller stops the work, it ends, and the next call works.
TEST(SameOnAnyThreads, StopsWherever) {
  const ThreadCount set(3);
  const Mesh mesh = shapes::icosphere(5);
  const BuildOptions options{.relative_tolerance = 2e-4};
  int calls = 0;
  build_grid(mesh, options, [&](double, std::string_view) { return ++calls > 0; });
  ASSERT_GT(calls, 2);  // how many depends on how much of the work other threads take
  for (int last = 1; last < calls; ++last) {
    int so_far = 0;
    try {
      build_grid(mesh, options, [&](double, std::string_view) { return ++so_far < last; });
    } catch (const Error& error) {
      ASSERT_EQ(error.code(), ErrorCode::kAborted);
    }
    EXPECT_LE(so_far, last);
  }
}

TEST(SameOnAnyThreads, ProgressNeverFalls) {
  const ThreadCount set(3);
  double last = 0;
  build_grid(many_spheres(), {}, [&](double fraction, std::string_view) {
    EXPECT_GE(fraction, last);
    last = fraction;
    return true;
  });
  EXPECT_EQ(last, 1);
}

}  // namespace
}  // namespace kdm
