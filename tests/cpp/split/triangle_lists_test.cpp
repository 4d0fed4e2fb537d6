// SPDX-License-Identifier: MIT
// Lists handed down the tree: never a triangle too few, and hardly one too many.
#include "split/triangle_lists.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <set>

#include "geometry/triangle_box.h"
#include "support/random.h"

namespace kdm {
namespace {

std::vector<LatticeTriangle> random_triangles(int count, double size, check::Random& random) {
  std::vector<LatticeTriangle> triangles;
  for (int i = 0; i < count; ++i) {
    const Vec3 centre = random.point(0.3, 0.7);
    LatticeTriangle t{};
    for (LatticePoint& corner : t) {
      const Vec3 p = centre + random.point(-size, size);
      for (int k = 0; k < 3; ++k) corner[k] = static_cast<std::int32_t>(p[k] * kLatticeSize);
      // Some corners lie on planes that cells are split at.
      if (random.below(4) == 0) corner[random.below(3)] &= ~0xffff;
    }
    triangles.push_back(t);
  }
  return triangles;
}

using Visit = std::function<void(const LatticeBox&, ListRange)>;

// Splits at midpoints in turn and shows the list of every leaf.
void descend(TriangleLists& lists, const LatticeBox& box, ListRange range, int depth,
             const Visit& visit) {
  if (depth == 12 || range.size() == 0) {
    visit(box, range);
    return;
  }
  const int axis = depth % 3;
  const std::int32_t value = box.lo[axis] + (box.hi[axis] - box.lo[axis]) / 2;
  const TriangleLists::Children children = lists.divide(range, axis, value);
  LatticeBox below = box;
  below.hi[axis] = value;
  LatticeBox above = box;
  above.lo[axis] = value;
  descend(lists, below, children.below, depth + 1, visit);
  descend(lists, above, children.above, depth + 1, visit);
  lists.release(children.below);
}

std::set<Index> triangles_of(const TriangleLists& lists, ListRange range) {
  std::set<Index> result;
  for (const ListEntry& entry : lists.entries(range)) result.insert(entry.triangle);
  return result;
}

TEST(TriangleLists, StartWithAll) {
  check::Random random(1);
  const std::vector<LatticeTriangle> triangles = random_triangles(10, 0.2, random);
  const TriangleLists lists(triangles);
  ASSERT_EQ(lists.all().size(), 10u);
  for (const ListEntry& entry : lists.entries(lists.all())) {
    const LatticeTriangle& t = triangles[entry.triangle];
    for (int k = 0; k < 3; ++k) {
      EXPECT_EQ(entry.lo[k], std::min({t[0][k], t[1][k], t[2][k]}));
      EXPECT_EQ(entry.hi[k], std::max({t[0][k], t[1][k], t[2][k]}));
    }
  }
}

TEST(TriangleLists, SidesAndStraddlers) {
  // Below, above, across; touching the plane x = 100 from both sides; lying in it.
  const std::vector<LatticeTriangle> triangles{
      {{{10, 0, 0}, {20, 9, 0}, {20, 0, 9}}},    {{{110, 0, 0}, {120, 9, 0}, {120, 0, 9}}},
      {{{90, 0, 0}, {120, 9, 0}, {95, 0, 9}}},   {{{90, 0, 0}, {100, 9, 0}, {95, 0, 9}}},
      {{{100, 0, 0}, {120, 9, 0}, {130, 0, 9}}}, {{{100, 0, 0}, {100, 9, 0}, {100, 0, 9}}}};
  TriangleLists lists(triangles);
  const TriangleLists::Children children = lists.divide(lists.all(), 0, 100);
  const std::set<Index> below = triangles_of(lists, children.below);
  const std::set<Index> above = triangles_of(lists, children.above);
  // A vertex on the plane counts as below it.
  for (const Index t : {0u, 2u, 3u, 5u}) EXPECT_EQ(below.count(t), 1u) << t;
  for (const Index t : {1u, 2u, 4u}) EXPECT_EQ(above.count(t), 1u) << t;
  EXPECT_EQ(below.count(1), 0u);
  for (const Index t : {0u, 3u, 5u}) EXPECT_EQ(above.count(t), 0u) << t;
  const std::set<Index> straddlers(lists.straddlers().begin(), lists.straddlers().end());
  std::set<Index> crossing;
  for (const Index i : straddlers) crossing.insert(lists.entry(i).triangle);
  EXPECT_EQ(crossing.count(2), 1u);
  EXPECT_EQ(crossing.count(4), 1u) << "its corner lies just below the plane";
  for (const Index t : {0u, 1u, 3u, 5u}) EXPECT_EQ(crossing.count(t), 0u) << t;
}

TEST(TriangleLists, NoTriangleThatMeetsALeafIsMissing) {
  for (const double size : {0.01, 0.1, 0.3}) {
    check::Random random(2);
    const std::vector<LatticeTriangle> triangles = random_triangles(60, size, random);
    TriangleLists lists(triangles);
    std::size_t listed = 0;
    std::size_t meeting = 0;
    descend(lists, LatticeBox(), lists.all(), 0, [&](const LatticeBox& box, ListRange range) {
      const std::set<Index> present = triangles_of(lists, range);
      ASSERT_EQ(present.size(), range.size()) << "no triangle is listed twice";
      listed += present.size();
      for (Index t = 0; t < triangles.size(); ++t) {
        if (!triangle_meets_box(triangles[t], box)) continue;
        ++meeting;
        ASSERT_EQ(present.count(t), 1u) << "triangle " << t;
      }
    });
    EXPECT_GT(meeting, triangles.size());
    EXPECT_LT(static_cast<double>(listed), 1.25 * static_cast<double>(meeting)) << "few too many";
  }
}

TEST(TriangleLists, BoundsHoldThePartInTheCell) {
  check::Random random(3);
  const std::vector<LatticeTriangle> triangles = random_triangles(60, 0.2, random);
  TriangleLists lists(triangles);
  int checked = 0;
  descend(lists, LatticeBox(), lists.all(), 0, [&](const LatticeBox& box, ListRange range) {
    for (const ListEntry& entry : lists.entries(range)) {
      for (int k = 0; k < 3; ++k) {
        ASSERT_GE(entry.lo[k], box.lo[k]);
        ASSERT_LE(entry.hi[k], box.hi[k]);
      }
      const ClippedPolygon part = clip_to_box(triangles[entry.triangle], box);
      for (int i = 0; i < part.size; ++i) {
        ++checked;
        for (int k = 0; k < 3; ++k) {
          ASSERT_GE(part.corners[i][k], entry.lo[k] - 1e-6);
          ASSERT_LE(part.corners[i][k], entry.hi[k] + 1e-6);
        }
      }
    }
  });
  EXPECT_GT(checked, 1000);
}

TEST(TriangleLists, ATriangleIsNotListedWhereItsBoundsOnlyReach) {
  // A triangle across the diagonal of a square: the corner cells away from it are free.
  const std::int32_t s = kLatticeSize / 2;
  const std::vector<LatticeTriangle> triangles{
      {{{s - 1000, s + 1000, 0}, {s + 1000, s - 1000, 0}, {s, s, 100000}}}};
  TriangleLists lists(triangles);
  const auto first = lists.divide(lists.all(), 0, s - 500);
  const auto corner = lists.divide(first.below, 1, s + 400);
  EXPECT_EQ(corner.below.size(), 0u);
  EXPECT_EQ(corner.above.size(), 1u);
}

TEST(TriangleLists, ReleaseGivesTheRoomBack) {
  check::Random random(4);
  const std::vector<LatticeTriangle> triangles = random_triangles(50, 0.2, random);
  TriangleLists lists(triangles);
  const auto first = lists.divide(lists.all(), 0, kLatticeSize / 2);
  const std::set<Index> below = triangles_of(lists, first.below);
  for (int i = 0; i < 100; ++i) {
    descend(lists, LatticeBox(), first.above, 10, [](const LatticeBox&, ListRange) {});
  }
  const auto again = lists.divide(lists.all(), 0, kLatticeSize / 2);
  EXPECT_EQ(again.below.begin, first.above.end) << "everything above was given back";
  EXPECT_EQ(triangles_of(lists, first.below), below) << "and nothing below was touched";
  EXPECT_EQ(triangles_of(lists, again.below), below);
}

}  // namespace
}  // namespace kdm
