// SPDX-License-Identifier: MIT
// What is wrong with the topology of a cell, one fault at a time.
#include "split/topology_check.h"

#include <gtest/gtest.h>

#include "support/cell_scene.h"
#include "support/shapes.h"

namespace kdm {
namespace {

using check::CellScene;
using check::with_room;
using shapes::box;

std::optional<TopologyFault> fault_of(const CellScene& scene) {
  return TopologyCheck(scene.surface).find_fault(scene.surface_in_cell);
}

TEST(TopologyCheck, ACornerHasNoFault) {
  const CellScene scene(with_room(shapes::cube()), Vec3(0.5, 0.5, 0.5), Vec3(1.01, 1.01, 1.01));
  ASSERT_EQ(scene.surface_in_cell.pieces.all().size(), 1u);
  EXPECT_FALSE(fault_of(scene));
}

TEST(TopologyCheck, TwoSheetsHaveNoFault) {
  const CellScene scene(with_room(box(Vec3(-2, -2, 0), Vec3(2, 2, 0.01))), Vec3(-1, -1, -1),
                        Vec3(1, 1, 1));
  ASSERT_EQ(scene.surface_in_cell.pieces.all().size(), 2u);
  EXPECT_FALSE(fault_of(scene));
}

// The bar meets two faces of the cell in closed curves and no edge of it.
TEST(TopologyCheck, AThinBarThroughTheCellHasAClosedCurve) {
  const CellScene scene(with_room(box(Vec3(0, -0.1, -2), Vec3(0.3, 0.1, 2))), Vec3(-1, -1, -1),
                        Vec3(1, 1, 1));
  ASSERT_TRUE(scene.surface_in_cell.crossings.all.empty());
  const std::optional<TopologyFault> fault = fault_of(scene);
  ASSERT_TRUE(fault);
  const auto* curve = std::get_if<ClosedCurve>(&*fault);
  ASSERT_NE(curve, nullptr);
  EXPECT_EQ(curve->axis, 2);
  EXPECT_EQ(curve->piece, 0u);
  EXPECT_NEAR(curve->section.lo[0], scene.on_lattice(0, 0), 2);
  EXPECT_NEAR(curve->section.hi[0], scene.on_lattice(0.3, 0), 2);
  EXPECT_NEAR(curve->section.lo[1], scene.on_lattice(-0.1, 1), 2);
  EXPECT_NEAR(curve->section.hi[1], scene.on_lattice(0.1, 1), 2);
}

// A peg that ends in the cell is a disk, but its outline is a closed curve on the cell's floor.
TEST(TopologyCheck, APegOnAFaceHasAClosedCurve) {
  const CellScene scene(with_room(box(Vec3(0, 0, -2), Vec3(0.2, 0.2, 0.5))), Vec3(-1, -1, -1),
                        Vec3(1, 1, 1));
  const std::optional<TopologyFault> fault = fault_of(scene);
  ASSERT_TRUE(fault);
  EXPECT_TRUE(std::holds_alternative<ClosedCurve>(*fault));
}

TEST(TopologyCheck, AClosedPartWithinTheCellIsNoDisk) {
  const CellScene scene(with_room(box(Vec3(0, 0, 0), Vec3(0.2, 0.2, 0.2))), Vec3(-1, -1, -1),
                        Vec3(1, 1, 1));
  const std::optional<TopologyFault> fault = fault_of(scene);
  ASSERT_TRUE(fault);
  EXPECT_TRUE(std::holds_alternative<NoDisk>(*fault));
}

// The cell's edge along z pierces a small box, of which a quarter lies in the cell.
TEST(TopologyCheck, APartAroundOneEdgeIsAPillow) {
  const CellScene scene(with_room(box(Vec3(-0.1, -0.1, 0.4), Vec3(0.1, 0.1, 0.6))), Vec3(0, 0, 0),
                        Vec3(1, 1, 1));
  ASSERT_EQ(scene.surface_in_cell.crossings.kept, 2u);
  const std::optional<TopologyFault> fault = fault_of(scene);
  ASSERT_TRUE(fault);
  const auto* pillow = std::get_if<Pillow>(&*fault);
  ASSERT_NE(pillow, nullptr);
  EXPECT_EQ(pillow->piece, 0u);
}

// A box that reaches beyond the cells around the edge comes out with volume.
TEST(TopologyCheck, ALongPartAroundOneEdgeIsNoPillow) {
  const CellScene scene(with_room(box(Vec3(-2, -0.1, 0.4), Vec3(0.1, 0.1, 0.6))), Vec3(0, 0, 0),
                        Vec3(1, 1, 1));
  ASSERT_EQ(scene.surface_in_cell.crossings.kept, 2u);
  EXPECT_FALSE(fault_of(scene));
}

}  // namespace
}  // namespace kdm
