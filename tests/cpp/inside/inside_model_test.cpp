// SPDX-License-Identifier: MIT
// What every inside model promises: states that depend on the place alone, and crossings that lead
// from one state to the next.
#include "inside/make_inside_model.h"

#include <gtest/gtest.h>

#include <string>

#include "inside/winding.h"
#include "support/random.h"
#include "support/shapes.h"

namespace kdm {
namespace {

// A surface and one kind of model for it.
class Kind {
 public:
  Kind(const Mesh& mesh, InsideRule rule)
      : rule_(rule),
        surface_(prepare_surface(mesh, {.inside = rule, .winding_threshold = 0.5})),
        model_(make_inside_model(surface_, {.inside = rule, .winding_threshold = 0.5}, 1.0)) {}

  const Surface& surface() const { return surface_; }
  InsideModel& model() { return *model_; }
  bool is_inside(int state) const {
    return surface_.repair ? state != 0 : kdm::is_inside(rule_, state);
  }

  std::vector<Crossing> crossings_on(int axis, const LatticePoint& low, std::int32_t high) const {
    const std::int32_t p = low[next_axis(axis)];
    const std::int32_t q = low[previous_axis(axis)];
    std::vector<Crossing> found;
    for (TriangleId t = 0; t < surface_.triangles.size(); ++t) {
      const int sign = line_crosses(surface_.triangles[t], axis, p, q);
      if (sign == 0) continue;
      const LinePosition position = crossing_position(surface_.triangles[t], axis, p, q);
      if (floor_of(position) < low[axis] || floor_of(position) >= high) continue;
      found.push_back({position, t, sign > 0});
    }
    return found;
  }

  std::vector<ClassifiedCrossing> plan(int axis, const LatticePoint& low, std::int32_t high,
                                       int state_low, int state_high) {
    std::vector<Crossing> found = crossings_on(axis, low, high);
    std::vector<ClassifiedCrossing> planned;
    model_->plan_edge({axis, low, high, state_low, state_high}, found, planned);
    EXPECT_EQ(planned.size(), found.size()) << "every crossing is classified";
    return planned;
  }

  // The state at the vertex, reached from the root's side along the axis.
  int state_along(int axis, const LatticePoint& vertex) {
    int winding = 0;
    LatticePoint low = vertex;
    low[axis] = 0;
    for (const Crossing& crossing : crossings_on(axis, low, vertex[axis])) {
      winding = state_after(winding, crossing);
    }
    return model_->state_at(vertex, surface_.sheet ? 0 : winding);
  }

 private:
  InsideRule rule_;
  Surface surface_;
  std::unique_ptr<InsideModel> model_;
};

LatticePoint random_vertex(check::Random& random) {
  LatticePoint p;
  for (std::int32_t& x : p) x = 1 + static_cast<std::int32_t>(random.below(kLatticeSize - 1));
  return p;
}

// Corners of the solid's own mesh, where every decision is a tie.
LatticePoint mesh_vertex(const Surface& surface, check::Random& random) {
  const auto t = random.below(static_cast<Index>(surface.triangles.size()));
  return surface.triangles[t][random.below(3)];
}

const std::vector<std::pair<Mesh, InsideRule>>& solids() {
  static const std::vector<std::pair<Mesh, InsideRule>> all = {
      {shapes::nested_shells(), InsideRule::kPositive},
      {shapes::nested_spheres(), InsideRule::kOdd},
      {shapes::inverted(shapes::nested_shells()), InsideRule::kNonzero},
      {shapes::stairs(4), InsideRule::kRepair},                        // closed: counted
      {shapes::open(shapes::icosphere(3), 40), InsideRule::kRepair}};  // the oracle
  return all;
}

TEST(InsideModel, AVertexHasOneStateAlongEveryAxis) {
  for (const auto& [mesh, rule] : solids()) {
    Kind kind(mesh, rule);
    check::Random random(4);
    int inside = 0;
    for (int trial = 0; trial < 300; ++trial) {
      const LatticePoint p =
          trial % 2 == 0 ? random_vertex(random) : mesh_vertex(kind.surface(), random);
      const int state = kind.state_along(0, p);
      EXPECT_EQ(kind.state_along(1, p), state);
      EXPECT_EQ(kind.state_along(2, p), state);
      inside += kind.is_inside(state) ? 1 : 0;
    }
    EXPECT_GT(inside, 0);
    EXPECT_LT(inside, 300);
  }
}

// The splitting face lies on both halves of the cell; each half takes the states at its corners
// from other edges: those that lead to the face from below, and from above.
TEST(InsideModel, BothFacesOfASplitHaveTheSameStates) {
  for (const auto& [mesh, rule] : solids()) {
    Kind kind(mesh, rule);
    check::Random random(5);
    for (int trial = 0; trial < 200; ++trial) {
      const LatticePoint p = random_vertex(random);
      const int axis = trial % 3;
      const int from_below = kind.state_along(axis, p);
      // From above: the crossings between the vertex and the root's far side, which is outside.
      int winding = 0;
      for (const Crossing& crossing : kind.crossings_on(axis, p, kLatticeSize)) {
        winding -= state_after(0, crossing);
      }
      EXPECT_EQ(kind.model().state_at(p, winding), from_below);
    }
  }
}

TEST(InsideModel, CrossingsLeadFromOneEndOfAnEdgeToTheOther) {
  for (const auto& [mesh, rule] : solids()) {
    Kind kind(mesh, rule);
    check::Random random(6);
    for (int trial = 0; trial < 200; ++trial) {
      const int axis = trial % 3;
      const LatticePoint low = random_vertex(random);
      LatticePoint top = low;
      top[axis] = kLatticeSize - static_cast<std::int32_t>(
                                     random.below(static_cast<Index>(kLatticeSize - low[axis])));
      const int state_low = kind.state_along(axis, low);
      const int state_high = kind.state_along(axis, top);
      const auto planned = kind.plan(axis, low, top[axis], state_low, state_high);
      int state = state_low;
      LinePosition last = 0;
      for (const ClassifiedCrossing& c : planned) {
        EXPECT_GE(c.position(), last) << "they ascend";
        last = c.position();
        if (c.kept() && !kind.surface().repair) {
          EXPECT_EQ(c.leaving(), kind.is_inside(state));
          EXPECT_NE(kind.is_inside(c.state_after()), kind.is_inside(state));
        }
        if (c.kept()) state = c.state_after();
      }
      // A hole between the ends gets its hit only when all cells are made.
      if (!kind.surface().repair) {
        EXPECT_EQ(kind.is_inside(state), kind.is_inside(state_high));
      }
    }
  }
}

TEST(InsideModel, ASheetKeepsEveryCrossingAsItRuns) {
  Kind kind(shapes::nested_shells(), InsideRule::kSheet);
  const LatticePoint low{kLatticeSize / 2 + 9, kLatticeSize / 2 + 5, 0};
  const auto planned = kind.plan(2, low, kLatticeSize, 0, 0);
  ASSERT_GE(planned.size(), 4u);
  for (const ClassifiedCrossing& c : planned) {
    EXPECT_TRUE(c.kept());
    EXPECT_EQ(c.leaving(), points_up(kind.surface().triangles[c.triangle()], 2));
    EXPECT_EQ(c.state_after(), 0);
  }
}

TEST(InsideModel, OnlyTheOracleCountsWork) {
  Kind counted(shapes::cube(), InsideRule::kPositive);
  Kind asked(shapes::open(shapes::cube(), 2), InsideRule::kRepair);
  const LatticePoint middle{kLatticeSize / 2, kLatticeSize / 2, kLatticeSize / 2};
  counted.model().state_at(middle, 1);
  const std::size_t before = asked.model().work();
  asked.model().state_at(middle, 1);
  const std::size_t after = asked.model().work();
  EXPECT_EQ(counted.model().work(), 0u);
  EXPECT_GT(after, before);
  asked.model().state_at(middle, 0);
  EXPECT_EQ(asked.model().work(), after) << "answers are remembered";
  GridStats stats;
  asked.model().report(stats);
  EXPECT_EQ(stats.winding_threshold, 0.5);
}

TEST(ClassifiedCrossing, HoldsWhatItIsGiven) {
  const ClassifiedCrossing last(~LinePosition{0}, (1u << 30) - 2, -7, CrossingRole::kBounds, false);
  EXPECT_EQ(last.position(), ~LinePosition{0});
  EXPECT_EQ(last.triangle(), (1u << 30) - 2);
  EXPECT_EQ(last.state_after(), -7);
  EXPECT_TRUE(last.kept());
  EXPECT_FALSE(last.leaving());
  const ClassifiedCrossing invented(5, kNone, 1, CrossingRole::kInner, true);
  EXPECT_EQ(invented.triangle(), kNone);
  EXPECT_FALSE(invented.kept());
  EXPECT_TRUE(invented.leaving());
}

}  // namespace
}  // namespace kdm
