// SPDX-License-Identifier: MIT
// What is noted of the triangles that meet a cell.
#include "split/cell_triangles.h"

#include <gtest/gtest.h>

#include "support/cell_scene.h"
#include "support/random.h"
#include "support/shapes.h"

namespace kdm {
namespace {

using check::CellScene;
using check::with_room;

// On a snapped mesh many corners lie just in the sides' planes.
TEST(CellTriangles, OutcodesSayWhereCornersLie) {
  const Mesh ball = shapes::snapped(shapes::icosphere(2), 0.25);
  for (const double size : {0.25, 0.3, 0.5, 1.0}) {
    const CellScene scene(with_room(ball), Vec3::Constant(0.5), Vec3::Constant(0.5 + size));
    const CellTriangles& triangles = scene.surface_in_cell.triangles;
    ASSERT_FALSE(triangles.empty());
    for (MemberId m = 0; m < triangles.size(); ++m) {
      const LatticeTriangle& t = triangles.corners(m);
      EXPECT_EQ(triangles.outcodes(m), outcodes(t, scene.box));
      for (int i = 0; i < 3; ++i) {
        EXPECT_EQ(triangles.outcodes(m)[i] == 0, vertex_in_box(t[i], scene.box));
      }
      for (int axis = 0; axis < 3; ++axis) {
        for (const bool high : {false, true}) {
          EXPECT_EQ(triangles.outcodes_at_face(m, axis, high),
                    outcodes(t, triangles.face(axis, high)));
        }
      }
    }
  }
}

}  // namespace
}  // namespace kdm
