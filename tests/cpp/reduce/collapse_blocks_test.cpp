// SPDX-License-Identifier: MIT
// What is reduced block by block is as good as what is reduced as a whole, and does not depend on
// the number of threads.
#include "reduce/collapse_blocks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "kdmanifold/error.h"
#include "kdmanifold/reduce.h"
#include "support/mesh_assert.h"
#include "support/shapes.h"
#include "support/sheets.h"
#include "support/threads.h"

namespace kdm {
namespace {

struct SharedCase {
  std::string name;
  Mesh mesh;
  ReduceOptions options;
};

// Groups of faces that lie side by side.
std::vector<Index> in_quarters(const Mesh& mesh) {
  std::vector<Index> groups;
  for (const Triangle& t : mesh.triangles) {
    const Vec3& p = mesh.positions[t[0]];
    groups.push_back((p.x() > 0 ? 1u : 0u) + (p.y() > 0 ? 2u : 0u));
  }
  return groups;
}

// Each face its own source, and the normals of a ball.
Mesh with_sources(Mesh ball) {
  for (Index t = 0; t < ball.triangles.size(); ++t) {
    ball.source_faces.push_back(t);
    ball.source_operands.push_back(t % 3);
    for (const Index corner : ball.triangles[t]) {
      const Eigen::Vector3f normal = ball.positions[corner].normalized().cast<float>();
      ball.corner_normals.push_back({normal[0], normal[1], normal[2]});
    }
  }
  return ball;
}

// All but the last three are cut into several blocks.
std::vector<SharedCase> shared_cases() {
  const Mesh ball = shapes::icosphere(5);
  const Mesh rough = shapes::jittered(ball, 0.003, 5);
  const Mesh shell = shapes::merged({ball, shapes::inverted(shapes::icosphere(5, 0.95))});
  const Mesh gap = shapes::merged({shapes::inverted(ball), shapes::icosphere(5, 0.99)});
  const Mesh sheet =
      shapes::translated(shapes::grid_sheet(90, 80, [](double x, double y) { return 0.3 * x * y; }),
                         Vec3(-0.5, -0.5, 0));
  return {{"rough ball", rough, {.error = 0.02}},
          {"thin shell", shell, {.error = 0.05}},
          {"narrow gap", gap, {.error = 0.03}},
          {"sheet with a rim", sheet, {.error = 0.002}},
          {"ball with sources", with_sources(ball), {.error = 0.01}},
          {"levels of a rough ball", rough, {.error = 0.05, .target_triangles = {3000, 200, 20}}},
          {"ball with groups", ball, {.error = 0.01, .keep_groups = in_quarters(ball)}},
          {"ball by number alone", ball, {.target_triangles = {9000, 100}}}};
}

ReducedMesh reduced_by(int threads, const SharedCase& one) {
  const ThreadCount set(threads);
  return reduce(one.mesh, one.mesh, one.options);
}

TEST(CollapseBlocks, AreTheSameWithAnyNumberOfThreads) {
  for (const SharedCase& one : shared_cases()) {
    SCOPED_TRACE(one.name);
    const ReducedMesh alone = reduced_by(1, one);
    EXPECT_LT(alone.triangles.size(), one.mesh.triangles.size() / 2);
    for (const int threads : {2, 5}) {
      const ReducedMesh shared = reduced_by(threads, one);
      EXPECT_EQ(alone.positions, shared.positions);
      EXPECT_EQ(alone.triangles, shared.triangles);
      EXPECT_EQ(alone.source_faces, shared.source_faces);
      EXPECT_EQ(alone.source_operands, shared.source_operands);
      EXPECT_EQ(alone.corner_normals, shared.corner_normals);
      EXPECT_EQ(alone.report.flips, shared.report.flips);
      EXPECT_EQ(alone.report.collapses, shared.report.collapses);
      ASSERT_EQ(alone.levels.size(), shared.levels.size());
      for (std::size_t i = 0; i < alone.levels.size(); ++i) {
        EXPECT_EQ(alone.levels[i].positions, shared.levels[i].positions);
        EXPECT_EQ(alone.levels[i].triangles, shared.levels[i].triangles);
        EXPECT_EQ(alone.levels[i].error.to_input.rms, shared.levels[i].error.to_input.rms);
        EXPECT_EQ(alone.levels[i].error.to_output.rms, shared.levels[i].error.to_output.rms);
      }
    }
  }
}

// With one group for all faces nothing is cut.
TEST(CollapseBlocks, LeaveAsFewTriangles) {
  for (SharedCase& one : shared_cases()) {
    if (!one.options.keep_groups.empty() || !one.options.target_triangles.empty()) continue;
    if (!one.mesh.source_faces.empty()) continue;
    SCOPED_TRACE(one.name);
    const ReducedMesh in_blocks = reduced_by(2, one);
    one.options.keep_groups.assign(one.mesh.triangles.size(), 0);
    const ReducedMesh whole = reduced_by(1, one);
    EXPECT_NE(in_blocks.triangles, whole.triangles);
    EXPECT_LT(static_cast<double>(in_blocks.triangles.size()),
              1.05 * static_cast<double>(whole.triangles.size()));
  }
}

TEST(CollapseBlocks, StayWithinTheToleranceAndMeetNothing) {
  for (const SharedCase& one : shared_cases()) {
    SCOPED_TRACE(one.name);
    const ReducedMesh made = reduced_by(2, one);
    EXPECT_EQ(find_self_intersections(made).pairs, 0u);
    const check::MeshCheck before = check::check_mesh(one.mesh);
    const check::MeshCheck after = check::check_mesh(made);
    EXPECT_EQ(after.components, before.components);
    EXPECT_EQ(after.boundary_loops, before.boundary_loops);
    EXPECT_EQ(after.euler_characteristic, before.euler_characteristic);
    // Every point is compared with every face: only where there are few.
    if (one.options.error == 0 || one.mesh.triangles.size() > 25000) continue;
    EXPECT_LT(check::distance_to(one.mesh, made), 1.3 * one.options.error);
    EXPECT_LT(check::distance_to(made, one.mesh), 1.3 * one.options.error);
  }
}

// The caller hears of progress on its own thread, and can stop the work wherever it is.
TEST(CollapseBlocks, ReportAndStop) {
  const SharedCase one = shared_cases().front();
  for (const int threads : {1, 3}) {
    const ThreadCount set(threads);
    const std::thread::id caller = std::this_thread::get_id();
    for (std::size_t last = 1; last <= 12; ++last) {
      std::vector<double> fractions;
      const auto hear = [&](double fraction, std::string_view) {
        EXPECT_EQ(std::this_thread::get_id(), caller);
        fractions.push_back(fraction);
        return fractions.size() < last;
      };
      ErrorCode code = ErrorCode::kInvalidOption;
      try {
        reduce(one.mesh, one.mesh, one.options, hear);
      } catch (const Error& error) {
        code = error.code();
      }
      EXPECT_EQ(code, ErrorCode::kAborted);
      EXPECT_EQ(fractions.size(), last);
      EXPECT_TRUE(std::is_sorted(fractions.begin(), fractions.end()));
      EXPECT_LE(fractions.back(), 1);
    }
  }
}

}  // namespace
}  // namespace kdm
