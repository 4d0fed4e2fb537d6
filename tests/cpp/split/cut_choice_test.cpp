// SPDX-License-Identifier: MIT
// Where cells are split: for fit, for topology, and within which limits.
#include "split/cut_choice.h"

#include <gtest/gtest.h>

#include "support/cell_scene.h"
#include "support/shapes.h"

namespace kdm {
namespace {

using check::CellScene;
using check::with_room;
using shapes::box;

constexpr int kMaxDepth = 40;
constexpr double kFine = 16;  // lattice units

std::int32_t middle(const LatticeBox& box, int axis) {
  return box.lo[axis] + extent(box, axis) / 2;
}

// A cell around the corner (1, 1, 1) of a cube, longest along y.
struct CornerScene : CellScene {
  CornerScene()
      : CellScene(with_room(shapes::cube()), Vec3(0.5, 0.2, 0.5), Vec3(1.01, 1.01, 1.01)) {}
};

// A bar along z through a cell, wider along x than along y.
struct BarScene : CellScene {
  BarScene()
      : CellScene(with_room(shapes::box(Vec3(0, -0.1, -2), Vec3(0.3, 0.1, 2))), Vec3(-1, -1, -1),
                  Vec3(1, 1, 1)) {}
};

std::optional<Split> split_for_topology(const CellScene& scene, CutChoice& cuts,
                                        const std::optional<Split>& between_parts = {}) {
  const auto fault = TopologyCheck(scene.surface).find_fault(scene.surface_in_cell);
  EXPECT_TRUE(fault);
  return cuts.split_for_topology(scene.view(), scene.surface_in_cell, *fault, between_parts,
                                 TopologyFloor::kAtTolerance);
}

TEST(CutChoice, HalvesTheLongestExtent) {
  const CornerScene scene;
  CutChoice cuts(scene.surface, kFine, kMaxDepth, CutPosition::kHalving);
  const std::optional<Split> split = cuts.split_for_fit(scene.view());
  ASSERT_TRUE(split);
  EXPECT_EQ(split->axis, 1);
  EXPECT_EQ(split->value, middle(scene.box, 1));
}

TEST(CutChoice, AnOctreeTakesTheAxesInTurn) {
  const CornerScene scene;
  CutChoice cuts(scene.surface, kFine, kMaxDepth, CutPosition::kInTurn);
  for (int depth = 0; depth < 6; ++depth) {
    const std::optional<Split> split = cuts.split_for_fit(scene.view(depth));
    ASSERT_TRUE(split);
    EXPECT_EQ(split->axis, depth % 3);
    EXPECT_EQ(split->value, middle(scene.box, depth % 3));
  }
}

TEST(CutChoice, AFeatureIsCutThrough) {
  // The little box lies in the cell with all its triangles; so its centre is the minimiser.
  const CellScene scene(with_room(box(Vec3(0.2, -0.5, -0.3), Vec3(0.4, -0.3, -0.1))),
                        Vec3(-1, -1, -1), Vec3(1, 1, 1));
  CutChoice cuts(scene.surface, kFine, kMaxDepth, CutPosition::kFeature);
  const std::optional<Split> split = cuts.split_for_fit(scene.view());
  ASSERT_TRUE(split);
  const Vec3 centre = scene.surface.lattice.to_lattice(Vec3(0.3, -0.4, -0.2));
  EXPECT_NEAR(split->value, centre[split->axis], 2);
}

TEST(CutChoice, NothingIsCutAtTheGreatestDepth) {
  const CornerScene corner;
  const BarScene bar;
  for (const CutPosition position :
       {CutPosition::kHalving, CutPosition::kInTurn, CutPosition::kFeature}) {
    CutChoice cuts(corner.surface, kFine, 7, position);
    EXPECT_TRUE(cuts.split_for_fit(corner.view(6)));
    EXPECT_FALSE(cuts.split_for_fit(corner.view(7)));
    CutChoice none(bar.surface, kFine, 0, position);
    EXPECT_FALSE(split_for_topology(bar, none));
  }
}

// No cut is nearer to a side than 1/32 of the tolerance.
TEST(CutChoice, AThinCellIsNotCut) {
  const CornerScene scene;
  const double length = extent(scene.box, 1);
  CutChoice wide_enough(scene.surface, 15 * length, kMaxDepth, CutPosition::kHalving);
  EXPECT_TRUE(wide_enough.split_for_fit(scene.view()));
  CutChoice too_thin(scene.surface, 17 * length, kMaxDepth, CutPosition::kHalving);
  EXPECT_FALSE(too_thin.split_for_fit(scene.view()));
}

TEST(CutChoice, ABarIsCutAlongItsAxisThroughItsMiddle) {
  const BarScene scene;
  CutChoice cuts(scene.surface, kFine, kMaxDepth, CutPosition::kHalving);
  const std::optional<Split> split = split_for_topology(scene, cuts);
  ASSERT_TRUE(split);
  EXPECT_EQ(split->axis, 0) << "across its greater width";
  EXPECT_NEAR(split->value, scene.on_lattice(0.15, 0), 2);
}

TEST(CutChoice, AClosedPartIsCutThroughItsMiddle) {
  const CellScene scene(with_room(box(Vec3(0, 0.2, 0), Vec3(0.2, 0.8, 0.3))), Vec3(-1, -1, -1),
                        Vec3(1, 1, 1));
  CutChoice cuts(scene.surface, kFine, kMaxDepth, CutPosition::kHalving);
  const std::optional<Split> split = split_for_topology(scene, cuts);
  ASSERT_TRUE(split);
  EXPECT_EQ(split->axis, 1) << "across its greatest length";
  EXPECT_NEAR(split->value, scene.on_lattice(0.5, 1), 2);
}

TEST(CutChoice, APillowIsCutAcrossItsEdge) {
  // Longer along x than along the edge that pierces it.
  const CellScene scene(with_room(box(Vec3(-0.1, -0.1, 0.4), Vec3(0.7, 0.1, 0.6))), Vec3(0, 0, 0),
                        Vec3(1, 1, 1));
  CutChoice cuts(scene.surface, kFine, kMaxDepth, CutPosition::kHalving);
  const std::optional<Split> split = split_for_topology(scene, cuts);
  ASSERT_TRUE(split);
  EXPECT_EQ(split->axis, 2);
  EXPECT_NEAR(split->value, scene.on_lattice(0.5, 2), 2);
}

TEST(CutChoice, APlaneBetweenPartsComesFirstWhereItHasRoom) {
  const BarScene scene;
  const double tolerance = 640;  // so cuts keep 20 lattice units away from the sides
  CutChoice cuts(scene.surface, tolerance, kMaxDepth, CutPosition::kHalving);
  const auto axis_of = [&](std::int32_t from_side) {
    return split_for_topology(scene, cuts, Split{1, scene.box.lo[1] + from_side})->axis;
  };
  EXPECT_EQ(axis_of(20), 1);
  EXPECT_EQ(axis_of(19), 0) << "the bar is cut instead";
}

// Whatever is asked, cuts keep away from the sides of cells: by 1/32 of the tolerance, and by four
// lattice units where the surface is embedded.
TEST(CutChoice, EmbeddedTopologyIsCutFiner) {
  const BarScene scene;
  const auto fault = TopologyCheck(scene.surface).find_fault(scene.surface_in_cell);
  ASSERT_TRUE(fault);
  const double longest = extent(scene.box, longest_axis(scene.box));
  CutChoice cuts(scene.surface, 20 * longest, kMaxDepth, CutPosition::kHalving);
  const auto split_down_to = [&](TopologyFloor floor) {
    return cuts.split_for_topology(scene.view(), scene.surface_in_cell, *fault, {}, floor);
  };
  EXPECT_FALSE(split_down_to(TopologyFloor::kAtTolerance));
  EXPECT_TRUE(split_down_to(TopologyFloor::kAtLattice));
}

// Cells whose longest extent is below 1/8 of the tolerance.
TEST(CutChoice, SmallCellsAreBelowTheFloor) {
  const BarScene scene;
  const double length = extent(scene.box, longest_axis(scene.box));
  CutChoice above(scene.surface, 7.9 * length, kMaxDepth, CutPosition::kHalving);
  EXPECT_FALSE(above.is_below_topology_floor(scene.surface_in_cell));
  EXPECT_TRUE(split_for_topology(scene, above));
  CutChoice below(scene.surface, 8.1 * length, kMaxDepth, CutPosition::kHalving);
  EXPECT_TRUE(below.is_below_topology_floor(scene.surface_in_cell));
}

}  // namespace
}  // namespace kdm
