// SPDX-License-Identifier: MIT
// Cutting polygons: count, orientation, area without overlap, edges kept.
#include "io/triangulate.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <random>

namespace kdm {
namespace {

using Polygon = std::vector<Vec3>;

std::vector<Triangle> cut(const Polygon& polygon) {
  std::vector<Index> corners(polygon.size());
  for (Index i = 0; i < corners.size(); ++i) corners[i] = i;
  std::vector<Triangle> triangles(polygon.size() - 2);
  Triangulator().cut(polygon, corners.data(), corners.size(), triangles.data());
  return triangles;
}

Vec3 area_vector(const Vec3& a, const Vec3& b, const Vec3& c) { return (b - a).cross(c - a) / 2; }

Vec3 area_vector(const Polygon& polygon) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
    sum += area_vector(polygon[0], polygon[i], polygon[i + 1]);
  }
  return sum;
}

// The triangles' edges cancel except for the polygon's own: neighbours stay joined.
void expect_same_outline(const std::vector<Triangle>& triangles, std::size_t count) {
  std::map<std::pair<Index, Index>, int> balance;
  const auto add = [&](Index from, Index to, int sign) {
    balance[{std::min(from, to), std::max(from, to)}] += from < to ? sign : -sign;
  };
  for (const Triangle& t : triangles) {
    for (std::size_t k = 0; k < 3; ++k) add(t[k], t[(k + 1) % 3], 1);
  }
  for (Index i = 0; i < count; ++i) add(i, i + 1 == count ? 0 : i + 1, -1);
  for (const auto& [edge, sum] : balance) {
    EXPECT_EQ(sum, 0) << "edge " << edge.first << " " << edge.second;
  }
}

// A simple flat polygon is cut properly iff no triangle is turned over and the areas add up.
void expect_proper(const Polygon& polygon) {
  const std::vector<Triangle> triangles = cut(polygon);
  expect_same_outline(triangles, polygon.size());
  const Vec3 whole = area_vector(polygon);
  const double size = whole.norm();
  double sum = 0;
  for (const Triangle& t : triangles) {
    const Vec3 part = area_vector(polygon[t[0]], polygon[t[1]], polygon[t[2]]);
    EXPECT_GE(part.dot(whole), -1e-12 * size * size);
    sum += part.norm();
  }
  EXPECT_NEAR(sum, size, 1e-9 * size);
}

// In the plane, on its back, and tilted in space.
void expect_proper_everywhere(const Polygon& polygon) {
  expect_proper(polygon);
  Polygon other(polygon.rbegin(), polygon.rend());
  expect_proper(other);
  for (Vec3& p : other) p = Vec3(p.y(), p.z() + 100, p.x());
  expect_proper(other);
  for (Vec3& p : other) p = Vec3(p.x() + p.y(), p.y() - p.z(), p.z() + 0.5 * p.x());
  expect_proper(other);
  // Begun at each corner in turn.
  for (std::size_t shift = 1; shift < std::min<std::size_t>(polygon.size(), 12); ++shift) {
    other = polygon;
    std::rotate(other.begin(), other.begin() + static_cast<std::ptrdiff_t>(shift), other.end());
    expect_proper(other);
  }
}

// The triangles, each from its lowest corner on, in ascending order.
std::vector<Triangle> sorted(std::vector<Triangle> triangles) {
  for (Triangle& t : triangles)
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  std::sort(triangles.begin(), triangles.end());
  return triangles;
}

TEST(Triangulate, TheBackIsCutLikeTheFront) {
  std::mt19937 random(5);
  for (Index count = 5; count < 40; ++count) {
    Polygon polygon;
    for (Index i = 0; i < count; ++i) {
      const double angle = 2 * std::numbers::pi * i / count;
      const double radius = 1 + static_cast<double>(random() % 1000) / 700;
      polygon.emplace_back(radius * std::cos(angle), radius * std::sin(angle), angle);
    }
    const std::vector<Triangle> front = sorted(cut(polygon));
    for (const Index first : {Index{0}, Index{1}, count / 2}) {
      std::vector<Index> corners(count);
      for (Index i = 0; i < count; ++i) corners[i] = (first + count - i) % count;
      std::vector<Triangle> back(count - 2);
      Triangulator().cut(polygon, corners.data(), count, back.data());
      for (Triangle& t : back) std::swap(t[1], t[2]);
      EXPECT_EQ(sorted(back), front) << count << " corners from " << first << " on";
    }
  }
}

TEST(Triangulate, ConvexQuadIsCutFromItsFirstCorner) {
  EXPECT_EQ(cut({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}),
            (std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}}));
}

TEST(Triangulate, ConcaveQuads) {
  //  3
  //  |\        the corner 2 is reflex
  //  | 2-.
  //  0----1
  expect_proper_everywhere({{0, 0, 0}, {1, 0, 0}, {0.2, 0.2, 0}, {0, 1, 0}});
}

TEST(Triangulate, Shapes) {
  expect_proper_everywhere(  // L
      {{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}});
  expect_proper_everywhere(  // U
      {{0, 0, 0}, {3, 0, 0}, {3, 3, 0}, {2, 3, 0}, {2, 1, 0}, {1, 1, 0}, {1, 3, 0}, {0, 3, 0}});
  Polygon star;
  for (int i = 0; i < 50; ++i) {
    const double r = i % 2 == 0 ? 1 : 0.3, a = i * 3.14159265358979 / 25;
    star.push_back({r * std::cos(a), r * std::sin(a), 0});
  }
  expect_proper_everywhere(star);
}

TEST(Triangulate, CollinearCorners) {
  // Corners in the middle of each edge, as neighbours of different size leave them.
  expect_proper_everywhere(
      {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {2, 2, 0}, {1, 2, 0}, {0, 2, 0}, {0, 1, 0}});
  expect_proper_everywhere({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {4, 0, 0}, {0, 4, 0}});
  // None of the triangles of a square with one more corner need be flat.
  for (const Triangle& t : cut({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}})) {
    const Polygon p = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}};
    EXPECT_GT(area_vector(p[t[0]], p[t[1]], p[t[2]]).norm(), 0.5);
  }
}

TEST(Triangulate, HolesCutOpenByABridge) {
  // A square with a square hole; the bridge from (0, 0) to (1, 1) is walked twice.
  expect_proper_everywhere({{0, 0, 0},
                            {4, 0, 0},
                            {4, 4, 0},
                            {0, 4, 0},
                            {0, 0, 0},
                            {1, 1, 0},
                            {1, 3, 0},
                            {3, 3, 0},
                            {3, 1, 0},
                            {1, 1, 0}});
  // Two holes bridged from the same corner.
  expect_proper_everywhere({{0, 0, 0},
                            {8, 0, 0},
                            {8, 4, 0},
                            {0, 4, 0},
                            {0, 0, 0},
                            {1, 2, 0},
                            {1, 3, 0},
                            {2, 3, 0},
                            {2, 2, 0},
                            {1, 2, 0},
                            {0, 0, 0},
                            {5, 1, 0},
                            {5, 2, 0},
                            {6, 2, 0},
                            {6, 1, 0},
                            {5, 1, 0}});
}

TEST(Triangulate, RepeatedCorners) {
  expect_proper_everywhere(
      {{0, 0, 0}, {0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {2, 2, 0}, {2, 2, 0}, {0, 2, 0}});
  // A spike without width.
  expect_proper_everywhere({{0, 0, 0}, {2, 0, 0}, {3, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}});
}

TEST(Triangulate, RandomStarShapedPolygons) {
  std::mt19937 random(7);
  const auto number = [&] { return static_cast<double>(random() % 1000) / 1000; };
  for (int round = 0; round < 300; ++round) {
    Polygon polygon;
    const int count = 4 + static_cast<int>(random() % 40);
    for (int i = 0; i < count; ++i) {
      const double a = 2 * 3.14159265358979 * (i + 0.9 * number()) / count;
      const double r = 0.1 + number();
      polygon.push_back({r * std::cos(a), r * std::sin(a), 0});
    }
    expect_proper(polygon);
  }
}

TEST(Triangulate, LongPolygons) {
  Polygon comb = {{0, -1, 0}};
  for (int i = 0; i < 500; ++i) comb.push_back({double(i), i % 2 ? 50.0 : 0.0, 0});
  comb.push_back({500, -1, 0});
  expect_proper(comb);
  Polygon circle;
  for (int i = 0; i < 2000; ++i) {
    const double a = 2 * 3.14159265358979 * i / 2000;
    circle.push_back({std::cos(a), std::sin(a), 0});
  }
  expect_proper(circle);
  Polygon spiral;
  for (int i = 100; i < 1000; ++i) {
    spiral.push_back({(i + 20) * std::cos(0.1 * i), (i + 20) * std::sin(0.1 * i), 0});
  }
  for (int i = 1000; i-- > 100;) {
    spiral.push_back({i * std::cos(0.1 * i), i * std::sin(0.1 * i), 0});
  }
  expect_proper(spiral);
}

TEST(Triangulate, PolygonsWithoutAreaKeepTheirOutline) {
  const Polygon cases[] = {
      {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {1, 0, 0}},
      {{1, 1, 1}, {1, 1, 1}, {1, 1, 1}, {1, 1, 1}, {1, 1, 1}, {1, 1, 1}},
      {{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}},                       // an eight
      {{0, 0, 0}, {1e300, 0, 0}, {1e300, 1e300, 0}, {0, 1e300, 1e300}},   // overflows
      {{0, 0, 0}, {1e-320, 0, 0}, {1e-320, 1e-320, 0}, {0, 1e-320, 0}}};  // underflows
  for (const Polygon& polygon : cases) {
    expect_same_outline(cut(polygon), polygon.size());
  }
}

TEST(Triangulate, PolygonsThatCutThemselvesEnd) {
  std::mt19937 random(11);
  for (const std::size_t count : {5u, 6u, 10u, 30u, 100u}) {
    Polygon polygon;
    for (std::size_t i = 0; i < count; ++i) {
      polygon.push_back({double(random() % 64), double(random() % 64), double(random() % 64)});
    }
    expect_same_outline(cut(polygon), count);
  }
}

TEST(Triangulate, OneTriangulatorServesManyPolygons) {
  Triangulator triangulator;
  const Polygon square = {{0, 0, 0}, {1, 0, 0}, {0.4, 0.4, 0}, {0, 1, 0}};
  const Index corners[] = {0, 1, 2, 3};
  std::vector<Triangle> first(2), again(2);
  triangulator.cut(square, corners, 4, first.data());
  Polygon large;
  std::vector<Index> all;
  for (Index i = 0; i < 500; ++i) {
    large.push_back({std::cos(i * 0.01256637), std::sin(i * 0.01256637), 0});
    all.push_back(i);
  }
  std::vector<Triangle> many(498);
  triangulator.cut(large, all.data(), all.size(), many.data());
  triangulator.cut(square, corners, 4, again.data());
  EXPECT_EQ(first, again);
}

}  // namespace
}  // namespace kdm
