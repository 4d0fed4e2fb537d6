// SPDX-License-Identifier: MIT
// No member that a way along grid lines may meet is passed over.
#include "split/line_members.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/cell_scene.h"
#include "support/random.h"

namespace kdm {
namespace {

TEST(LineMembers, HoldEveryMemberThatALineMayMeet) {
  const Mesh ball = shapes::icosphere(3, 1);
  LineMembers line_members;
  check::Random random(2);
  int met = 0;
  for (const Mesh& part : {ball, shapes::cube(), shapes::merged({ball, shapes::torus()})}) {
    const check::CellScene scene(check::with_room(part), Vec3(-0.4, -1.2, -0.3), Vec3(1.1, 0.9, 1));
    const CellTriangles& cell = scene.surface_in_cell.triangles;
    ASSERT_GT(cell.size(), 0u);
    line_members.list(cell);
    for (int i = 0; i < 300; ++i) {
      const LatticeBox& box = cell.cell();
      LatticePoint at = box.lo;
      for (int axis = 0; axis < 3; ++axis) {
        std::vector<MemberId> listed;
        line_members.for_each(axis, at, [&](MemberId m) { listed.push_back(m); });
        ASSERT_TRUE(std::is_sorted(listed.begin(), listed.end()));
        for (MemberId m = 0; m < cell.size(); ++m) {
          const LatticeBox& bounds = cell.bounds(m);
          bool may_meet = true;
          for (const int k : {next_axis(axis), previous_axis(axis)}) {
            may_meet = may_meet && bounds.lo[k] <= at[k] && at[k] <= bounds.hi[k];
          }
          if (!may_meet) continue;
          ++met;
          ASSERT_TRUE(std::binary_search(listed.begin(), listed.end(), m)) << "axis " << axis;
        }
        const auto width = static_cast<std::uint32_t>(box.hi[axis] - box.lo[axis] + 1);
        at[axis] = box.lo[axis] + static_cast<std::int32_t>(random.below(width));
      }
    }
  }
  EXPECT_GT(met, 1000);
}

}  // namespace
}  // namespace kdm
