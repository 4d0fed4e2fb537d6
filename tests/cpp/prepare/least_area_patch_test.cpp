// SPDX-License-Identifier: MIT
// Patches of least area: right on small polygons, sound and quick on any.
#include "prepare/least_area_patch.h"

#include <gtest/gtest.h>

#include <map>

#include "geometry/triangle.h"
#include "support/random.h"
#include "support/sanitized.h"
#include "support/shapes.h"

namespace kdm {
namespace {

std::vector<Triangle> patch_over(const std::vector<Vec3>& points,
                                 const std::vector<std::uint64_t>& edges = {}) {
  std::vector<PointId> polygon;
  for (PointId p = 0; p < points.size(); ++p) polygon.push_back(p);
  std::vector<Triangle> out;
  LeastAreaPatch(points, edges).make(polygon, std::vector<Vec3>(points.size(), Vec3::Zero()), out);
  return out;
}

double area_of(const std::vector<Triangle>& triangles, const std::vector<Vec3>& points) {
  double area = 0;
  for (const Triangle& t : triangles) {
    area += doubled_area_vector(points[t[0]], points[t[1]], points[t[2]]).norm() / 2;
  }
  return area;
}

// Every edge of the polygon once in its direction, every other edge once each way.
void expect_sound(const std::vector<Triangle>& triangles, Index corners) {
  ASSERT_EQ(triangles.size(), corners - 2u);
  std::map<std::pair<Index, Index>, int> uses;
  for (const Triangle& t : triangles) {
    for (int i = 0; i < 3; ++i) ++uses[{t[i], t[(i + 1) % 3]}];
  }
  for (Index i = 0; i < corners; ++i) EXPECT_EQ((uses[{i, (i + 1) % corners}]), 1);
  for (const auto& [edge, count] : uses) {
    EXPECT_EQ(count, 1);
    const bool own = edge.second == (edge.first + 1) % corners;
    EXPECT_EQ(uses.count({edge.second, edge.first}), own ? 0u : 1u);
  }
}

std::vector<Vec3> ring(Index corners, double wave) {
  std::vector<Vec3> points;
  for (Index i = 0; i < corners; ++i) {
    const double angle = 6.283185307179586 * i / corners;
    points.emplace_back(shapes::cosine(angle), shapes::sine(angle), wave * shapes::sine(3 * angle));
  }
  return points;
}

TEST(LeastAreaPatch, TakesTheShorterDiagonalOfASkewSquare) {
  const std::vector<Vec3> points = {Vec3(0, 0, 0), Vec3(1, 0, 0.1), Vec3(3, 1, 0), Vec3(0, 1, 0.1)};
  const std::vector<Triangle> patch = patch_over(points);
  expect_sound(patch, 4);
  EXPECT_NEAR(
      area_of(patch, points),
      std::min(area_of({{0, 1, 2}, {0, 2, 3}}, points), area_of({{0, 1, 3}, {1, 2, 3}}, points)),
      1e-12);
}

TEST(LeastAreaPatch, AvoidsEdgesThatTheMeshHas) {
  const std::vector<Vec3> points = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 1, 0), Vec3(0, 1, 0)};
  for (const auto& [low, high] : {std::pair{0u, 2u}, std::pair{1u, 3u}}) {
    for (const Triangle& t : patch_over(points, {std::uint64_t{low} << 32 | high})) {
      const auto has = [&](Index p) { return std::find(t.begin(), t.end(), p) != t.end(); };
      EXPECT_FALSE(has(low) && has(high));
    }
  }
}

// The mesh lies below a square: a patch on it is no better than one that is turned up.
TEST(LeastAreaPatch, AvoidsFolds) {
  const std::vector<Vec3> points = {Vec3(0, 0, 0), Vec3(2, 0, 0), Vec3(2, 0.1, 0), Vec3(1, 0.2, 0),
                                    Vec3(0, 0.1, 0)};
  std::vector<Vec3> beyond(5, Vec3(0, 0, 1));
  std::vector<Triangle> out;
  const std::vector<PointId> polygon = {0, 1, 2, 3, 4};
  const std::vector<std::uint64_t> edges;
  LeastAreaPatch(points, edges).make(polygon, beyond, out);
  expect_sound(out, 5);
}

TEST(LeastAreaPatch, AWavingRingIsSpanned) {
  for (const Index corners : {3u, 4u, 10u, 100u, check::kSanitized ? 200u : 500u}) {
    const std::vector<Vec3> points = ring(corners, 0.3);
    const std::vector<Triangle> patch = patch_over(points);
    expect_sound(patch, corners);
    if (corners >= 100) {
      EXPECT_NEAR(area_of(patch, points), 3.89, 0.01);
    }
  }
}

TEST(LeastAreaPatch, LargeRingsAreDivided) {
  for (const Index corners : {501u, 5000u, 100000u}) {
    if (check::kSanitized && corners > 501) continue;
    const std::vector<Vec3> points = ring(corners, 0.3);
    const std::vector<Triangle> patch = patch_over(points);
    expect_sound(patch, corners);
    EXPECT_NEAR(area_of(patch, points), 3.89, 0.01);
  }
}

TEST(LeastAreaPatch, AnyPolygonWillDo) {
  check::Random random(5);
  for (int round = 0; round < 50; ++round) {
    std::vector<Vec3> points;
    const Index corners = 3 + random.below(40);
    for (Index i = 0; i < corners; ++i) {
      points.push_back(round % 5 == 0 ? Vec3(random.unit(), 0, 0) : random.point(0, 1));
    }
    if (round % 7 == 0) points.back() = points.front();
    expect_sound(patch_over(points), corners);
  }
}

TEST(LeastAreaPatch, ManyLargePolygonsTakeNoLongerThanTheirCorners) {
  if (check::kSanitized) GTEST_SKIP() << "is about time, of which it takes minutes with sanitizers";
  const std::vector<Vec3> points = ring(500, 0.3);
  std::vector<PointId> polygon;
  for (PointId p = 0; p < 500; ++p) polygon.push_back(p);
  const std::vector<Vec3> beyond(500, Vec3::Zero());
  const std::vector<std::uint64_t> edges;
  LeastAreaPatch patch(points, edges);
  for (int i = 0; i < 1000; ++i) {
    std::vector<Triangle> out;
    patch.make(polygon, beyond, out);
    ASSERT_EQ(out.size(), 498u);
  }
}

}  // namespace
}  // namespace kdm
