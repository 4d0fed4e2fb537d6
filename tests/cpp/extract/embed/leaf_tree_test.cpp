// SPDX-License-Identifier: MIT
// The leaves that a box meets, against all leaves.
#include "extract/embed/leaf_tree.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/embed_stage.h"
#include "support/random.h"

namespace kdm {
namespace {

using check::EmbedStage;
using check::split_rules;

TEST(LeafTree, FindsEveryLeafThatABoxMeetsOnce) {
  check::Random random(7);
  for (const BuildOptions& options : split_rules()) {
    const EmbedStage stage(shapes::icosphere(2), options);
    const LeafTree tree(stage.view());
    std::vector<CellId> leaves;
    for (CellId c = 0; c < stage.grid.cells.size(); ++c) {
      if (stage.grid.cells[c].leaf()) leaves.push_back(c);
    }
    for (int n = 0; n < 100; ++n) {
      Vec3 lo;
      Vec3 hi;
      for (int i = 0; i < 3; ++i) {
        lo[i] = random.below(kLatticeSize);
        hi[i] = std::min<double>(kLatticeSize, lo[i] + random.below(kLatticeSize >> n % 12));
      }
      std::vector<CellId> expected;
      for (const CellId leaf : leaves) {
        const Vec3 leaf_lo = to_vec3(stage.boxes[leaf].lo);
        const Vec3 leaf_hi = to_vec3(stage.boxes[leaf].hi);
        if ((lo.array() <= leaf_hi.array()).all() && (hi.array() >= leaf_lo.array()).all()) {
          expected.push_back(leaf);
        }
      }
      // From the leaf that the box begins in, as from any other leaf that it meets.
      for (const CellId near : {expected.front(), expected.back()}) {
        std::vector<CellId> found;
        tree.for_each_leaf(near, lo, hi, [&](CellId leaf) { found.push_back(leaf); });
        std::sort(found.begin(), found.end());
        EXPECT_EQ(found, expected);
      }
    }
  }
}

}  // namespace
}  // namespace kdm
