// SPDX-License-Identifier: MIT
// Whether the crossings of a cell lie on one curve, told by their numbers on its sides.
#include "split/cell_crossings.h"

#include <gtest/gtest.h>

#include "support/cell_scene.h"
#include "support/random.h"
#include "support/sanitized.h"
#include "support/shapes.h"

namespace kdm {
namespace {

using check::CellScene;
using check::with_room;

TEST(CellCrossings, AFlatPieceIsCutInOneLoop) {
  const CellScene scene(with_room(shapes::box(Vec3(-2, -2, -2), Vec3(2, 2, 0))), Vec3(-1, -1, -1),
                        Vec3(1, 1, 1));
  ASSERT_EQ(scene.surface_in_cell.crossings.all.size(), 4u);
  EXPECT_TRUE(scene.surface_in_cell.crossings.form_one_loop());
}

// Blocks at opposite corners of the cell: no side has crossings with both.
TEST(CellCrossings, TwoCornersAreTwoLoops) {
  const CellScene scene(
      with_room(shapes::merged({shapes::box(Vec3(-2, -2, -2), Vec3(-0.5, -0.5, -0.5)),
                                shapes::box(Vec3(0.5, 0.5, 0.5), Vec3(2, 2, 2))})),
      Vec3(-1, -1, -1), Vec3(1, 1, 1));
  ASSERT_EQ(scene.surface_in_cell.crossings.all.size(), 6u);
  EXPECT_FALSE(scene.surface_in_cell.crossings.form_one_loop());
}

TEST(CellCrossings, OneLoopIsOfOnePiece) {
  check::Random random(3);
  const int tries = check::kSanitized ? 40 : 600;
  int loops = 0;
  int several = 0;
  for (int i = 0; i < tries; ++i) {
    const Mesh ball =
        shapes::jittered(shapes::icosphere(3), 0.2 * random.unit(), random.below(1000));
    const Vec3 centre = random.direction();
    const Vec3 half = random.point(0.05, 0.4);
    const CellScene scene(with_room(ball), centre - half, centre + half);
    const CellSurface& cell = scene.surface_in_cell;
    if (cell.crossings.all.empty()) continue;
    const PieceId first = cell.piece_of_triangle(cell.crossings.all.front().triangle);
    const bool one = std::all_of(cell.crossings.all.begin(), cell.crossings.all.end(),
                                 [&](const CellCrossing& crossing) {
                                   return cell.piece_of_triangle(crossing.triangle) == first;
                                 });
    if (!one) ++several;
    if (!cell.crossings.form_one_loop()) continue;
    ++loops;
    EXPECT_TRUE(one);
  }
  EXPECT_GT(loops, 10);
  EXPECT_GT(several, 2);
}

}  // namespace
}  // namespace kdm
