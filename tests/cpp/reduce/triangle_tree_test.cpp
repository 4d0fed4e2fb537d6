// SPDX-License-Identifier: MIT
#include "reduce/triangle_tree.h"

#include <gtest/gtest.h>

#include <set>

#include "geometry/distance.h"
#include "support/random.h"

namespace kdm {
namespace {

struct Triangles {
  std::vector<std::array<Vec3, 3>> corners;

  std::vector<SmallBox> boxes() const {
    std::vector<SmallBox> all;
    for (const auto& t : corners) all.push_back(small_box(t[0], t[1], t[2]));
    return all;
  }
  double squared_distance_of(TriangleId t, const Vec3& p) const {
    return squared_distance(p, corners[t][0], corners[t][1], corners[t][2]);
  }
};

Triangles random_triangles(check::Random& random, int count, double size) {
  Triangles all;
  for (int i = 0; i < count; ++i) {
    const Vec3 at = random.point(-1, 1);
    all.corners.push_back({at, at + size * random.point(-1, 1), at + size * random.point(-1, 1)});
  }
  return all;
}

TEST(TriangleTree, FindsTheNearestWhateverTheHint) {
  check::Random random(1);
  for (const int count : {1, 3, 5, 400}) {
    const Triangles all = random_triangles(random, count, 0.1);
    const TriangleTree tree(all.boxes());
    for (int i = 0; i < 300; ++i) {
      const Vec3 p = random.point(-1, 1);
      double least = 1e9;
      for (TriangleId t = 0; t < all.corners.size(); ++t) {
        least = std::min(least, all.squared_distance_of(t, p));
      }
      const TriangleId hint = i % 2 == 0 ? kNone : random.below(static_cast<Index>(count));
      const auto distance = [&](TriangleId t) { return all.squared_distance_of(t, p); };
      const TriangleId found = tree.nearest(p, 1e9, 0, hint, distance);
      ASSERT_NE(found, kNone);
      EXPECT_EQ(all.squared_distance_of(found, p), least);
      EXPECT_EQ(tree.nearest(p, least * 0.999, 0, hint, distance), kNone);
      const TriangleId enough = tree.nearest(p, 4 * least, 4 * least, hint, distance);
      ASSERT_NE(enough, kNone);
      EXPECT_LE(all.squared_distance_of(enough, p), 4 * least);
    }
  }
}

// Across it, a place on the curve would be infinitely far.
TEST(TriangleTree, TakesAMeshThatIsNextToFlat) {
  check::Random random(3);
  Triangles all = random_triangles(random, 400, 0.1);
  for (auto& corners : all.corners) {
    for (Vec3& corner : corners) corner[2] *= 1e-41;
  }
  const TriangleTree tree(all.boxes());
  for (TriangleId t = 0; t < 400; ++t) {
    const Vec3 p = (all.corners[t][0] + all.corners[t][1] + all.corners[t][2]) / 3;
    const auto distance = [&](TriangleId i) { return all.squared_distance_of(i, p); };
    const TriangleId found = tree.nearest(p, 1e9, 0, kNone, distance);
    ASSERT_NE(found, kNone);
    EXPECT_LE(distance(found), distance(t));
  }
}

TEST(TriangleTree, FindsWhatMeetsABoxWhileTrianglesComeAndGo) {
  check::Random random(2);
  Triangles all = random_triangles(random, 300, 0.2);
  TriangleTree tree(all.boxes());
  std::set<TriangleId> gone;
  for (int round = 0; round < 200; ++round) {
    const TriangleId t = random.below(static_cast<Index>(all.corners.size()));
    if (!gone.contains(t)) {
      if (random.coin()) {
        for (Vec3& p : all.corners[t]) p += 0.3 * random.point(-1, 1);
        tree.change(t, all.boxes()[t]);
      } else {
        tree.change(t, {});
        gone.insert(t);
      }
    }
    if (round % 50 == 49) tree.rebuild();
    const SmallBox box = small_box(random.point(-1, 1), 0.2);
    std::set<TriangleId> expected;
    const std::vector<SmallBox> boxes = all.boxes();
    for (TriangleId i = 0; i < boxes.size(); ++i) {
      if (!gone.contains(i) && boxes[i].meets(box)) expected.insert(i);
    }
    std::set<TriangleId> found;
    EXPECT_FALSE(tree.any_meeting(box, kNone, [&](TriangleId i) {
      found.insert(i);
      return false;
    }));
    EXPECT_EQ(found, expected);
  }
}

TEST(TriangleTree, HoldsNothing) {
  const TriangleTree tree(std::vector<SmallBox>{});
  const auto distance = [](TriangleId) { return 0.0; };
  EXPECT_EQ(tree.nearest(Vec3::Zero(), 1, 0, kNone, distance), kNone);
  EXPECT_FALSE(
      tree.any_meeting(small_box(Vec3::Zero(), 1), kNone, [](TriangleId) { return true; }));
}

}  // namespace
}  // namespace kdm
