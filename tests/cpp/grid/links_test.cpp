// SPDX-License-Identifier: MIT
#include "grid/links.h"

#include <gtest/gtest.h>

#include <vector>

#include "grid/validate.h"
#include "kdmanifold/build.h"
#include "kdmanifold/error.h"
#include "support/shapes.h"
#include "support/sheets.h"

namespace kdm {
namespace {

// A plate so thin that many faces have four hits.
GridData plate_grid(InsideRule inside = InsideRule::kPositive) {
  const Mesh plate = shapes::rotated(shapes::box(Vec3::Zero(), Vec3(1, 1, 0.02)), Vec3(1, 2, 3), 1);
  return build_grid(plate, {.strategy = SplitStrategy::kUniform, .depth = 12, .inside = inside})
      .data();
}

// The half-edges across the first face with exactly four hits that is no strip, in cyclic order.
std::vector<HalfEdgeId> four_half_edges(const GridData& grid) {
  std::vector<HalfEdgeId> found;
  for_each_face(grid, cell_boxes(grid), [&](const MinimalFace& face) {
    if (!found.empty() || face.strip() || face.hit_count() != 4) return;
    for_each_hit(
        face, [&](const FaceEdge& edge, HitId hit, int) { found.push_back(3 * hit + edge.slot); });
  });
  return found;
}

TEST(Links, JoinHalfEdgesThatMayBeLinked) {
  for (const InsideRule rule : {InsideRule::kPositive, InsideRule::kSheet}) {
    const GridData grid = plate_grid(rule);
    for (HalfEdgeId h = 0; h < grid.opposite.size(); ++h) {
      const HalfEdgeId other = grid.opposite[h];
      if (other == kNone) continue;
      ASSERT_TRUE(may_link(grid, h, other));
      ASSERT_EQ(end_leaf(grid, h), grid.start_leaf(other));
      ASSERT_FALSE(may_link(grid, h, h));
    }
  }
}

TEST(Links, OnlyWithinAFaceAndAgainstEachOther) {
  const GridData grid = plate_grid();
  const std::vector<HalfEdgeId> round = four_half_edges(grid);
  ASSERT_EQ(round.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i) {
    // Round a solid's face directions alternate.
    EXPECT_TRUE(may_link(grid, round[i], round[(i + 1) % 4]));
    EXPECT_FALSE(may_link(grid, round[i], round[(i + 2) % 4]));
  }
  std::size_t partners = 0;
  for (HalfEdgeId h = 0; h < grid.opposite.size(); ++h) {
    partners += may_link(grid, round[0], h) ? 1 : 0;
  }
  EXPECT_EQ(partners, 2u);
}

TEST(Links, AreExchangedByRelink) {
  GridData grid = plate_grid();
  const std::vector<HalfEdgeId> round = four_half_edges(grid);
  ASSERT_EQ(round.size(), 4u);
  const std::vector<HalfEdgeId> before = grid.opposite;
  const HalfEdgeId old_partner = before[round[0]];
  const HalfEdgeId new_partner = old_partner == round[1] ? round[3] : round[1];
  relink(grid, round[0], new_partner);
  EXPECT_EQ(grid.opposite[round[0]], new_partner);
  EXPECT_EQ(grid.opposite[old_partner], before[new_partner]);
  EXPECT_NO_THROW(validate(grid));
  relink(grid, round[0], new_partner);  // nothing is left to do
  EXPECT_NO_THROW(validate(grid));
  relink(grid, old_partner, round[0]);
  EXPECT_EQ(grid.opposite, before);
}

TEST(Links, OfSheetsMayBeTakenAwayAndLeaveTheBoundary) {
  GridData grid = plate_grid(InsideRule::kSheet);
  const std::vector<HalfEdgeId> round = four_half_edges(grid);
  ASSERT_EQ(round.size(), 4u);
  const std::vector<HalfEdgeId> before = grid.opposite;
  const HalfEdgeId partner = unlink(grid, round[0]);
  ASSERT_NE(partner, kNone);
  EXPECT_EQ(partner, before[round[0]]);
  EXPECT_EQ(grid.opposite[round[0]], kNone);
  EXPECT_EQ(grid.opposite[partner], kNone);
  EXPECT_EQ(unlink(grid, round[0]), kNone);
  EXPECT_NO_THROW(validate(grid));
  // The link to a half-edge without partner leaves that one's partner alone.
  const HalfEdgeId taken = may_link(grid, round[0], round[1]) && round[1] != partner   ? round[1]
                           : may_link(grid, round[0], round[3]) && round[3] != partner ? round[3]
                                                                                       : partner;
  const HalfEdgeId left = grid.opposite[taken];
  relink(grid, round[0], taken);
  EXPECT_EQ(grid.opposite[taken], round[0]);
  if (left != kNone) {
    EXPECT_EQ(grid.opposite[left], kNone);
  }
  EXPECT_NO_THROW(validate(grid));
}

}  // namespace
}  // namespace kdm
