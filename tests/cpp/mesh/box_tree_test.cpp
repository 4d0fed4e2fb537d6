// SPDX-License-Identifier: MIT
// Rays find the boxes that they meet, however a tree is divided.
#include "mesh/box_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "support/random.h"

namespace kdm {
namespace {

constexpr BoxTree::Division kDivisions[] = {BoxTree::Division::kMedians, BoxTree::Division::kCurve};

std::vector<Index> met_by(const std::vector<Box>& boxes, BoxTree::Division division,
                          const Vec3& origin, const Vec3& direction) {
  std::vector<Index> met;
  BoxTree(boxes, division).any_along(origin, direction, [&](Index i) {
    met.push_back(i);
    return false;
  });
  std::sort(met.begin(), met.end());
  return met;
}

// A tree of one box has no nodes but its leaf.
std::vector<Index> met_one_by_one(const std::vector<Box>& boxes, const Vec3& origin,
                                  const Vec3& direction) {
  std::vector<Index> met;
  for (Index i = 0; i < boxes.size(); ++i) {
    const std::vector<Box> alone{boxes[i]};
    if (!met_by(alone, BoxTree::Division::kMedians, origin, direction).empty()) met.push_back(i);
  }
  return met;
}

// Boxes in a room of this width, some of them in one place.
std::vector<Box> random_boxes(check::Random& random, const Vec3& width) {
  const auto point = [&] { return Vec3(random.point(0, 1).cwiseProduct(width)); };
  std::vector<Box> boxes;
  for (int i = 0; i < 400; ++i) {
    const Vec3 low = i % 4 == 0 && i > 0 ? boxes.front().min : point();
    boxes.push_back({low, low + 0.1 * point()});
  }
  return boxes;
}

TEST(BoxTree, RaysMeetEachOfTheirBoxesOnce) {
  check::Random random(5);
  std::size_t found = 0;
  for (const Vec3& width :
       {Vec3(1, 1, 1), Vec3(1e3, 1, 0), Vec3(0, 0, 1e-320), Vec3(1e140, 1, 1)}) {
    const std::vector<Box> boxes = random_boxes(random, width);
    for (int ray = 0; ray < 20; ++ray) {
      const Vec3 origin = boxes[random.below(400)].min;
      const Vec3 direction = random.direction();
      const std::vector<Index> expected = met_one_by_one(boxes, origin, direction);
      for (const BoxTree::Division division : kDivisions) {
        EXPECT_EQ(met_by(boxes, division, origin, direction), expected);
      }
      found += expected.size();
    }
  }
  EXPECT_GT(found, 400u);
}

TEST(BoxTree, MeetsNothingWithoutBoxes) {
  for (const BoxTree::Division division : kDivisions) {
    EXPECT_TRUE(met_by({}, division, Vec3(0, 0, 0), Vec3(1, 1, 1)).empty());
  }
}

}  // namespace
}  // namespace kdm
