// SPDX-License-Identifier: MIT
// Whether one vertex stands for a piece of the surface, on surfaces small enough to see it.
#include "split/fit_check.h"

#include <gtest/gtest.h>

#include "support/cell_scene.h"
#include "support/shapes.h"

namespace kdm {
namespace {

using check::CellScene;

struct Answer {
  bool clear_misfit;
  bool fits;
  bool operator==(const Answer&) const = default;
};

// Asks about one cell, with a tolerance in model units.
Answer ask(const CellScene& scene, double tolerance,
           LeafVertices vertices = LeafVertices::kOneEachPiece) {
  FitCheck check(scene.surface, scene.in_lattice(tolerance));
  check.plan_hits(scene.box, scene.surface_in_cell.crossings);
  const bool clear_misfit =
      check.is_clear_misfit(scene.box, scene.entries(), scene.surface_in_cell.crossings);
  return {clear_misfit, check.pieces_fit(scene.surface_in_cell, vertices)};
}

constexpr Answer kFits{false, true};
constexpr Answer kClearMisfit{true, false};

// A block whose top is flat at z = 0 but for a small pyramid over the origin.
Mesh block_with_pyramid(double height) {
  Mesh mesh;
  mesh.positions = {{-1, -1, -1},  {1, -1, -1},    {1, 1, -1},    {-1, 1, -1},     {-1, -1, 0},
                    {1, -1, 0},    {1, 1, 0},      {-1, 1, 0},    {-0.1, -0.1, 0}, {0.1, -0.1, 0},
                    {0.1, 0.1, 0}, {-0.1, 0.1, 0}, {0, 0, height}};
  mesh.triangles = {{0, 2, 1}, {0, 3, 2}};
  for (Index i = 0; i < 4; ++i) {
    const Index j = (i + 1) % 4;
    mesh.triangles.push_back({i, j, 4 + j});
    mesh.triangles.push_back({i, 4 + j, 4 + i});
    mesh.triangles.push_back({4 + i, 4 + j, 8 + j});
    mesh.triangles.push_back({4 + i, 8 + j, 8 + i});
    mesh.triangles.push_back({8 + i, 8 + j, 12});
  }
  return mesh;
}

TEST(FitCheck, AFlatPieceFits) {
  const CellScene scene(check::with_room(shapes::cube()), Vec3(0.2, 0.3, 0.9),
                        Vec3(0.4, 0.5, 1.01));
  ASSERT_EQ(scene.surface_in_cell.crossings.kept, 4u);
  EXPECT_EQ(ask(scene, 1e-4), kFits);
}

TEST(FitCheck, TheCornerOfACubeFits) {
  const CellScene scene(check::with_room(shapes::cube()), Vec3(0.9, 0.9, 0.9),
                        Vec3(1.01, 1.01, 1.01));
  ASSERT_EQ(scene.surface_in_cell.crossings.kept, 3u);
  EXPECT_EQ(ask(scene, 1e-4), kFits);
}

// The cell's edges meet the flat part only, so the tip lies off all planes by the height.
TEST(FitCheck, ATipBetweenTheEdgesFitsWithinTheToleranceOnly) {
  constexpr double kHeight = 0.02;
  const CellScene scene(check::with_room(block_with_pyramid(kHeight)), Vec3(-0.3, -0.3, -0.4),
                        Vec3(0.3, 0.3, 0.03));
  ASSERT_EQ(scene.surface_in_cell.crossings.kept, 4u);
  EXPECT_EQ(ask(scene, 0.9 * kHeight), kClearMisfit);
  EXPECT_EQ(ask(scene, 1.1 * kHeight), kFits);
}

// A block whose top is a saddle: flat amid its corners, which are bent up and down by turns.
Mesh block_with_saddle(double height) {
  Mesh mesh;
  mesh.positions = {{1, 0, 0},  {1, 1, height},   {0, 1, 0},  {-1, 1, -height},
                    {-1, 0, 0}, {-1, -1, height}, {0, -1, 0}, {1, -1, -height}};
  for (Index i = 0; i < 8; ++i) {
    mesh.positions.emplace_back(mesh.positions[i].x(), mesh.positions[i].y(), -1);
  }
  mesh.triangles = {{0, 2, 4}, {0, 4, 6}};
  for (Index i = 0; i < 8; ++i) {
    const Index j = (i + 1) % 8;
    mesh.triangles.push_back({8 + i, 8 + j, j});
    mesh.triangles.push_back({8 + i, j, i});
    if (i % 2 == 1) mesh.triangles.push_back({i - 1, i, j});
    if (i > 0 && i < 7) mesh.triangles.push_back({8, 8 + j, 8 + i});
  }
  return mesh;
}

// No vertex of the mesh lies in the cell, but the planes at its corners have no point in common.
TEST(FitCheck, AVertexOffThePlanesOfItsHitsIsAClearMisfit) {
  constexpr double kHeight = 0.05;
  const CellScene scene(check::with_room(block_with_saddle(kHeight)), Vec3(-0.8, -0.8, -0.5),
                        Vec3(0.8, 0.8, 0.5));
  ASSERT_EQ(scene.surface_in_cell.crossings.kept, 4u);
  EXPECT_EQ(ask(scene, 0.9 * kHeight), kClearMisfit);
  EXPECT_EQ(ask(scene, 1.1 * kHeight), kFits);
}

TEST(FitCheck, TwoSheetsNeedAVertexEach) {
  constexpr double kThickness = 0.02;
  const Mesh slab = shapes::box(Vec3(0, 0, 0), Vec3(1, 1, kThickness));
  const CellScene scene(check::with_room(slab), Vec3(0.3, 0.3, -0.1), Vec3(0.6, 0.6, 0.1));
  ASSERT_EQ(scene.surface_in_cell.pieces.all().size(), 2u);
  ASSERT_EQ(scene.surface_in_cell.crossings.kept, 8u);
  EXPECT_EQ(ask(scene, 1e-3), kFits);
  // The common vertex lies in the middle.
  const LeafVertices one = LeafVertices::kOneForAll;
  EXPECT_FALSE(ask(scene, 0.45 * kThickness, one).fits);
  EXPECT_TRUE(ask(scene, 0.55 * kThickness, one).fits);
}

// The common vertex lies amid the four sheets, near to the inner two and further from the outer
// two.
TEST(FitCheck, TheCommonVertexMeetsAllPlanes) {
  const Mesh slabs = shapes::merged({shapes::box(Vec3(0, 0, 0), Vec3(1, 1, 0.02)),
                                     shapes::box(Vec3(0, 0, 0.03), Vec3(1, 1, 0.05))});
  const CellScene scene(check::with_room(slabs), Vec3(0.3, 0.3, -0.1), Vec3(0.6, 0.6, 0.1));
  ASSERT_EQ(scene.surface_in_cell.pieces.all().size(), 4u);
  EXPECT_FALSE(ask(scene, 0.024, LeafVertices::kOneForAll).fits);
  EXPECT_TRUE(ask(scene, 0.026, LeafVertices::kOneForAll).fits);
}

TEST(FitCheck, SurfaceThatNoEdgeMeetsIsAClearMisfit) {
  const CellScene scene(check::with_room(shapes::cube()), Vec3(-0.01, -0.01, -0.5),
                        Vec3(1.01, 1.01, 1.01));
  ASSERT_TRUE(scene.surface_in_cell.crossings.all.empty());
  EXPECT_TRUE(ask(scene, 1e-3).clear_misfit);
  EXPECT_TRUE(ask(scene, 10.0).clear_misfit) << "at any tolerance";
}

}  // namespace
}  // namespace kdm
