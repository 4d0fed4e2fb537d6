// SPDX-License-Identifier: MIT
// Closed curves on the faces of cells.
#include "split/face_sections.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/shapes.h"

namespace kdm {
namespace {

// The bounds are those of one curve, not of all that the face cuts, nor of the triangles.
TEST(FaceSections, AClosedCurveHasItsOwnBounds) {
  const Mesh bar =
      shapes::rotated(shapes::box(Vec3(-1, -2, -20), Vec3(1, 2, 20)), Vec3::UnitY(), 0.5);
  const Surface surface =
      prepare_surface(shapes::merged({bar, shapes::translated(bar, Vec3(8, 0, 0))}));
  TriangleLists lists(surface.triangles);
  LatticeBox cell;
  cell.lo[2] = static_cast<std::int32_t>(surface.lattice.to_lattice(Vec3::Zero()).z());
  const TriangleLists::Children children = lists.divide(lists.all(), 2, cell.lo[2]);
  CellSurface surface_in_cell(surface);
  surface_in_cell.find_pieces(cell, lists.entries(children.above));
  ASSERT_EQ(surface_in_cell.pieces.all().size(), 2u);
  OneWaySections one_way;
  one_way.find(surface_in_cell);
  const std::optional<ClosedCurve> curve =
      FaceSections().find_closed_curve(surface_in_cell, one_way);
  ASSERT_TRUE(curve);
  EXPECT_EQ(curve->axis, 2);
  const double wide = 1 / std::cos(0.5);
  const Vec3 lo = surface.lattice.to_lattice(Vec3(-wide, -2, 0));
  const Vec3 hi = surface.lattice.to_lattice(Vec3(wide, 2, 0));
  for (int axis = 0; axis < 2; ++axis) {
    EXPECT_NEAR(curve->section.lo[axis], lo[axis], 4.0) << axis;
    EXPECT_NEAR(curve->section.hi[axis], hi[axis], 4.0) << axis;
  }
}

}  // namespace
}  // namespace kdm
