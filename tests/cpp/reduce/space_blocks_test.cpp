// SPDX-License-Identifier: MIT
#include "reduce/space_blocks.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "mesh/boxes.h"
#include "support/shapes.h"

namespace kdm {
namespace {

std::vector<Box> boxes_of(const Mesh& mesh) {
  std::vector<Box> out;
  for (const Triangle& t : mesh.triangles) {
    out.push_back(box_of(mesh.positions[t[0]], mesh.positions[t[1]], mesh.positions[t[2]]));
  }
  return out;
}

TEST(SpaceBlocks, HoldEachPointOnce) {
  const Mesh ball = shapes::icosphere(4);
  for (const double below : {0.5, 0.3}) {
    const std::vector<SpaceBlock> blocks = cut_space(boxes_of(ball), 500, below);
    EXPECT_GT(blocks.size(), 10u);
    for (const Vec3& p : ball.positions) {
      EXPECT_EQ(std::count_if(blocks.begin(), blocks.end(),
                              [&](const SpaceBlock& block) { return holds(block.box, 7 * p); }),
                1);
    }
  }
}

// What a block does not list has nothing in it, corners or else.
TEST(SpaceBlocks, ListWhatReachesIn) {
  const Mesh ball = shapes::icosphere(4);
  const std::vector<Box> boxes = boxes_of(ball);
  for (const SpaceBlock& block : cut_space(boxes, 500, 0.5)) {
    EXPECT_LE(block.triangles.size(), 500u);
    EXPECT_TRUE(std::is_sorted(block.triangles.begin(), block.triangles.end()));
    for (TriangleId t = 0; t < boxes.size(); ++t) {
      const bool reaches = (boxes[t].min.array() < block.box.max.array()).all() &&
                           (boxes[t].max.array() >= block.box.min.array()).all();
      EXPECT_EQ(std::binary_search(block.triangles.begin(), block.triangles.end(), t), reaches);
    }
  }
}

TEST(SpaceBlocks, EndWhereCuttingPartsNothing) {
  const std::vector<Box> same(100, Box{Vec3::Zero(), Vec3::Ones()});
  ASSERT_EQ(cut_space(same, 10, 0.5).size(), 1u);
  EXPECT_EQ(cut_space(same, 10, 0.5)[0].triangles.size(), 100u);
  EXPECT_TRUE(cut_space({}, 10, 0.5)[0].triangles.empty());
}

TEST(SpaceBlocks, LeaveOutWhatWasRemoved) {
  const std::vector<Box> boxes = {Box{Vec3::Zero(), Vec3::Ones()}, Box{}};
  EXPECT_EQ(cut_space(boxes, 10, 0.5)[0].triangles, (std::vector<TriangleId>{0}));
}

}  // namespace
}  // namespace kdm
