// SPDX-License-Identifier: MIT
// Reduced meshes do not depend on the number of threads, though steps change what others looked at.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "kdmanifold/error.h"
#include "kdmanifold/reduce.h"
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

// All have more than 5,000 triangles, so that five threads work.
std::vector<SharedCase> shared_cases() {
  const Mesh ball = shapes::icosphere(4);
  const Mesh rough = shapes::jittered(ball, 0.01, 5);
  const Mesh shell = shapes::merged({ball, shapes::inverted(shapes::icosphere(4, 0.95))});
  const Mesh gap = shapes::merged({shapes::inverted(ball), shapes::icosphere(4, 0.99)});
  const Mesh sheet =
      shapes::translated(shapes::grid_sheet(60, 50, [](double x, double y) { return 0.3 * x * y; }),
                         Vec3(-0.5, -0.5, 0));
  return {{"rough ball", rough, {.error = 0.02}},
          {"levels of a rough ball", rough, {.error = 0.05, .target_triangles = {3000, 200, 20}}},
          {"thin shell", shell, {.error = 0.05}},
          {"narrow gap", gap, {.error = 0.03}},
          {"sheet with a rim", sheet, {.error = 0.002}},
          {"sheet with groups", sheet, {.error = 0.002, .keep_groups = in_quarters(sheet)}},
          {"ball with sources", with_sources(ball), {.error = 0.01}},
          {"ball with groups", ball, {.error = 0.01, .keep_groups = in_quarters(ball)}},
          {"ball by number alone", ball, {.target_triangles = {2000, 100}}}};
}

ReducedMesh reduced_by(int threads, const SharedCase& one) {
  const ThreadCount set(threads);
  return reduce(one.mesh, one.mesh, one.options);
}

TEST(TrialsAhead, ChangeNothing) {
  for (const SharedCase& one : shared_cases()) {
    SCOPED_TRACE(one.name);
    const ReducedMesh alone = reduced_by(1, one);
    EXPECT_LT(alone.triangles.size(), one.mesh.triangles.size() / 2);
    for (const int threads : {2, 3, 5}) {
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

// The caller hears of the same progress, on its own thread, and can stop the work wherever it is.
TEST(TrialsAhead, ReportAndStopAsInTurn) {
  const SharedCase one = shared_cases().front();
  const auto heard_by = [&](int threads, std::size_t last) {
    const ThreadCount set(threads);
    std::vector<double> fractions;
    const auto hear = [&](double fraction, std::string_view) {
      fractions.push_back(fraction);
      return fractions.size() < last;
    };
    try {
      reduce(one.mesh, one.mesh, one.options, hear);
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::kAborted);
    }
    return fractions;
  };
  const std::vector<double> alone = heard_by(1, 1000);
  ASSERT_GT(alone.size(), 4u);
  EXPECT_EQ(heard_by(3, 1000), alone);
  for (std::size_t last = 1; last <= alone.size(); ++last) {
    EXPECT_EQ(heard_by(3, last).size(), last);
  }
}

}  // namespace
}  // namespace kdm
