// SPDX-License-Identifier: MIT
// What callbacks are told, and that a stopped call leaves everything usable.
#include "kdmanifold/progress.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "grid/validate.h"
#include "kdmanifold/build.h"
#include "kdmanifold/error.h"
#include "kdmanifold/extract.h"
#include "support/mesh_assert.h"
#include "support/shapes.h"

namespace kdm {
namespace {

struct Calls {
  std::vector<double> fractions;
  std::vector<std::string> phases;  // without repetitions

  bool operator()(double fraction, std::string_view phase) {
    fractions.push_back(fraction);
    if (phases.empty() || phases.back() != phase) phases.emplace_back(phase);
    return true;
  }
};

void expect_rising(const Calls& calls) {
  ASSERT_FALSE(calls.fractions.empty());
  EXPECT_EQ(calls.fractions.front(), 0);
  EXPECT_EQ(calls.fractions.back(), 1);
  for (std::size_t i = 1; i < calls.fractions.size(); ++i) {
    ASSERT_GE(calls.fractions[i], calls.fractions[i - 1]) << "call " << i;
  }
}

Mesh ring() { return shapes::torus(1, 0.3, 16, 8); }

const std::vector<BuildOptions>& strategies() {
  static const std::vector<BuildOptions> options{
      {.strategy = SplitStrategy::kAdaptive, .relative_tolerance = 0.005},
      {.strategy = SplitStrategy::kOctree, .depth = 12},
      {.strategy = SplitStrategy::kMedian},
      {.strategy = SplitStrategy::kUniform, .depth = 12}};
  return options;
}

TEST(Progress, BuildingRisesThroughItsPhases) {
  for (const BuildOptions& options : strategies()) {
    Calls calls;
    build_grid(ring(), options, std::ref(calls));
    expect_rising(calls);
    EXPECT_EQ(calls.phases, (std::vector<std::string>{"prepare", "build", "link"}));
  }
}

TEST(Progress, ExtractionRisesThroughItsPhases) {
  const Grid grid = build_grid(ring());
  for (const Strict strict : {Strict::kOff, Strict::kManifold, Strict::kEmbedded}) {
    Calls calls;
    extract(grid, {.strict = strict}, std::ref(calls));
    expect_rising(calls);
    EXPECT_EQ(calls.phases, (std::vector<std::string>{"loops", "vertices", "faces"}));
  }
}

TEST(Progress, ALongConstructionIsReportedOnItsWay) {
  Calls calls;
  const Grid grid =
      build_grid(ring(), {.strategy = SplitStrategy::kUniform, .depth = 18}, std::ref(calls));
  ASSERT_GT(grid.stats().cells, 20000u);
  EXPECT_GE(calls.fractions.size(), 4 + grid.stats().cells / 8192);
  Index within = 0;
  for (const double f : calls.fractions) within += f > 0.15 && f < 0.75 ? 1 : 0;
  EXPECT_GE(within, 2u) << "fractions spread over the construction";
}

// Stops at the call of that number; returns what was thrown, or the number of calls made.
template <typename Call>
std::pair<std::string, int> stopped_at(int number, Call call) {
  int calls = 0;
  try {
    call([&](double, std::string_view) { return calls++ != number; });
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kAborted);
    return {error_code_name(error.code()), calls};
  }
  return {"", calls};
}

TEST(Progress, BuildingStopsAtEveryCall) {
  const Mesh mesh = ring();
  for (const BuildOptions& options : strategies()) {
    int number = 0;
    for (;; ++number) {
      const auto [error, calls] = stopped_at(
          number, [&](const Progress& progress) { build_grid(mesh, options, progress); });
      if (error.empty()) {
        EXPECT_EQ(calls, number) << "all calls were tried";
        break;
      }
      ASSERT_EQ(error, "ABORTED");
      ASSERT_EQ(calls, number + 1) << "the first no ends it";
    }
    EXPECT_GE(number, 4);
    // After all that, a call works as if nothing had been.
    EXPECT_NO_THROW(validate(build_grid(mesh, options).data()));
  }
}

TEST(Progress, ExtractionStopsAtEveryCallAndLeavesTheGridAlone) {
  const Grid grid = build_grid(ring());
  const ExtractedMesh before = extract(grid);
  int number = 0;
  while (!stopped_at(number, [&](const Progress& progress) {
            extract(grid, {}, progress);
          }).first.empty()) {
    ++number;
  }
  EXPECT_GE(number, 4);
  EXPECT_NO_THROW(validate(grid.data()));
  const ExtractedMesh after = extract(grid);
  EXPECT_EQ(after.triangles, before.triangles);
  EXPECT_EQ(after.positions, before.positions);
}

TEST(Progress, ACallbackDoesNotChangeTheResult) {
  const Mesh mesh = ring();
  const auto yes = [](double, std::string_view) { return true; };
  EXPECT_EQ(extract(build_grid(mesh, {}, yes), {}, yes).positions,
            extract(build_grid(mesh)).positions);
}

TEST(Progress, WhatACallbackThrowsComesOut) {
  struct Mine {};
  EXPECT_THROW(
      build_grid(shapes::cube(), {}, [](double, std::string_view) -> bool { throw Mine(); }), Mine);
}

}  // namespace
}  // namespace kdm
