// SPDX-License-Identifier: MIT
#include "construct/cells_in_parts.h"

#include <gtest/gtest.h>

#include "inside/make_inside_model.h"
#include "support/shapes.h"
#include "support/threads.h"

namespace kdm {
namespace {

// A budget for a small surface, less all but some of its splits.
Budget budget_of(std::size_t splits) {
  Budget budget = Budget::for_repair(0, 0);
  std::size_t limit = 1;
  while (Budget(budget).take_splits(limit)) ++limit;
  budget.take_splits(limit - splits);
  return budget;
}

// Makes the cells of a sphere, in parts or not.
class SphereCells {
 public:
  std::optional<MadeCells> in_parts(const Budget& budget) {
    return make_cells_in_parts(task(*rule_), budget, [this](InsideModel& model) {
      return make_split_rule(surface_, model, options_, kTolerance, kMaxDepth);
    });
  }
  CellMaker alone(const Budget& budget) {
    CellMaker maker(task(*rule_), budget);
    maker.make_all();
    return maker;
  }
  bool may_be_shared(const CellMemory& memory) {
    memory_ = memory;
    return kdm::may_be_shared(task(*rule_));
  }

 private:
  static constexpr double kTolerance = 500;

  CellTask task(SplitRule& rule) {
    return {surface_, kMaxDepth, *model_, rule, memory_, progress_};
  }

  BuildOptions options_;
  Surface surface_ = prepare_surface(shapes::uv_sphere(48, 25));
  std::unique_ptr<InsideModel> model_ = make_inside_model(surface_, options_, kTolerance);
  std::unique_ptr<SplitRule> rule_ =
      make_split_rule(surface_, *model_, options_, kTolerance, kMaxDepth);
  CellMemory memory_;
  Progress progress_;
};

TEST(CellsInParts, AreThoseThatOneThreadMakes) {
  for (const int threads : {2, 3, 7}) {
    const ThreadCount set(threads);
    const std::optional<MadeCells> shared = SphereCells().in_parts(Budget());
    CellMaker alone = SphereCells().alone(Budget());
    ASSERT_TRUE(shared);
    ASSERT_EQ(shared->cells.size(), alone.made().cells.size());
    ASSERT_GT(shared->cells.size(), 1000u);
    for (std::size_t c = 0; c < shared->cells.size(); ++c) {
      const Cell& a = shared->cells[c];
      const Cell& b = alone.made().cells[c];
      ASSERT_EQ(a.leaf(), b.leaf());
      if (a.leaf()) continue;
      EXPECT_EQ(a.below(), b.below());
      EXPECT_EQ(a.axis(), b.axis());
      EXPECT_EQ(a.value(), b.value());
    }
    EXPECT_EQ(shared->crossings.all, alone.made().crossings.all);
    EXPECT_EQ(shared->crossings.edge_begin, alone.made().crossings.edge_begin);
    EXPECT_EQ(shared->unresolved, alone.made().unresolved);
  }
}

// With fewer splits than it takes, one thread has to say where they end.
TEST(CellsInParts, AreNotMadeBeyondABudget) {
  const ThreadCount set(2);
  const std::size_t splits = SphereCells().alone(Budget()).made().splits();
  for (const std::size_t left : {std::size_t{1}, splits / 2, splits}) {
    EXPECT_FALSE(SphereCells().in_parts(budget_of(left))) << left << " of " << splits;
    EXPECT_FALSE(SphereCells().alone(budget_of(left)).budget().sufficed());
  }
  EXPECT_TRUE(SphereCells().in_parts(budget_of(splits + 1)));
  EXPECT_TRUE(SphereCells().alone(budget_of(splits + 1)).budget().sufficed());
}

TEST(CellsInParts, AreMadeWhereNothingStandsAgainstIt) {
  FormerCells notes;
  {
    const ThreadCount set(2);
    EXPECT_TRUE(SphereCells().may_be_shared({}));
    EXPECT_FALSE(SphereCells().may_be_shared({nullptr, 0, &notes}));
    EXPECT_FALSE(SphereCells().may_be_shared({&notes, 0, nullptr}));
  }
  const ThreadCount set(1);
  EXPECT_FALSE(SphereCells().may_be_shared({}));
}

}  // namespace
}  // namespace kdm
