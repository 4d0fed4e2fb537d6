// SPDX-License-Identifier: MIT
// What shells that cross in a cell bound there, one way of crossing at a time.
#include "split/crossing_arcs.h"

#include <gtest/gtest.h>

#include "support/cell_scene.h"
#include "support/shapes.h"

namespace kdm {
namespace {

using check::CellScene;
using check::with_room;
using shapes::box;

using Crossed = CrossingArcs::Answer;

// Counts windings; `odd` says that only odd numbers are inside, as for a symmetric difference.
class Windings : public InsideModel {
 public:
  explicit Windings(bool odd) : odd_(odd) {}
  int state_at(const LatticePoint& /*vertex*/, int counted) override { return counted; }
  std::optional<bool> is_inside(int state) const override {
    return odd_ ? state % 2 != 0 : state > 0;
  }
  void plan_edge(const GridEdge& /*edge*/, std::vector<Crossing>& /*found*/,
                 std::vector<ClassifiedCrossing>& /*planned*/) override {}
  void finish_edges(const EdgeCrossings& /*planned*/, HitWriter& /*writer*/) override {}

 private:
  bool odd_;
};

// Looks at the cell from -1 to 1, whose lowest corner has the given winding number.
Crossed crossed(const std::vector<Mesh>& parts, int winding, bool odd = false) {
  CellScene scene(with_room(shapes::merged(parts)), Vec3(-1, -1, -1), Vec3(1, 1, 1));
  CellSurface& cell = scene.surface_in_cell;
  EXPECT_TRUE(cell.pieces.are_disks()) << "else nobody asks";
  cell.inner.assign(cell.triangles.size(), {});
  Windings model(odd);
  CellStates states(model);
  states.start(cell.triangles, winding);
  CrossingTriangles crossing;
  return CrossingArcs(states).join_pieces_to_disks(cell, crossing.find_pairs(cell.triangles));
}

// All that lies below a plane normal to an axis, as far as the cell and a little more.
Mesh below(int axis, double value, double room) {
  Vec3 lo = Vec3::Constant(-room);
  Vec3 hi = Vec3::Constant(room);
  lo[axis] = -room - 0.01;
  hi[axis] = value;
  return box(lo, hi);
}

TEST(CrossingArcs, TwoPlanesBoundADiskTogether) {
  EXPECT_EQ(crossed({below(0, 0.11, 1.5), below(2, 0.13, 1.6)}, 2), Crossed::kDisks);
  EXPECT_EQ(crossed({below(0, 0, 1.5), below(2, 0, 1.6)}, 2), Crossed::kDisks)
      << "edges meet edges where their triangles are cut in two";
}

TEST(CrossingArcs, FourSheetsThatMeetAlongACurveAreNoDisk) {
  EXPECT_EQ(crossed({below(0, 0.11, 1.5), below(2, 0.13, 1.6)}, 2, true), Crossed::kUnclear);
}

TEST(CrossingArcs, AChainOfPiecesBoundsADisk) {
  EXPECT_EQ(crossed({below(2, 0.13, 1.6), box(Vec3(-1.4, -1.5, -1.4), Vec3(-0.6, 1.5, 1.45)),
                     box(Vec3(0.55, -1.52, -1.42), Vec3(1.45, 1.53, 1.47))},
                    2),
            Crossed::kDisks)
      << "two walls stand on one floor";
}

// A prism along y whose upper edge lies at this height.
Mesh roof(double ridge) {
  Mesh mesh;
  for (const double y : {-1.5, 1.5}) {
    for (const Vec3& p : {Vec3(-1.4, y, -1.2), Vec3(1.4, y, -1.2), Vec3(0.02, y, ridge)}) {
      mesh.positions.push_back(p);
    }
  }
  mesh.triangles = {{0, 1, 2}, {3, 5, 4}, {0, 3, 4}, {0, 4, 1},
                    {1, 4, 5}, {1, 5, 2}, {2, 5, 3}, {2, 3, 0}};
  return mesh;
}

// A roof whose ridge runs along the plane: its two faces are one piece, which crosses the plane
// twice.
TEST(CrossingArcs, TwoArcsOfTheSamePiecesAskForSmallerCells) {
  EXPECT_EQ(crossed({below(2, 0.13, 1.6), roof(0.3)}, 2), Crossed::kTooMuch);
}

TEST(CrossingArcs, FacesOnEachOtherThatFaceTheSameWayAreOne) {
  const Mesh step = box(Vec3(-1.5, -1.4, -1.45), Vec3(0.13, 1.4, 0.25));
  EXPECT_EQ(crossed({below(2, 0.25, 1.6), step}, 2), Crossed::kDisks);
}

TEST(CrossingArcs, FacesOnEachOtherThatFaceOppositeWaysAreUnclear) {
  const Mesh upon = box(Vec3(-1.5, -1.4, 0.25), Vec3(0.13, 1.4, 1.45));
  EXPECT_EQ(crossed({below(2, 0.25, 1.6), upon}, 1), Crossed::kUnclear);
}

TEST(CrossingArcs, AnEdgeThatTouchesAFaceIsUnclear) {
  const Mesh upon = box(Vec3(-1.5, -1.4, 0.25), Vec3(1.52, 1.4, 1.45));
  EXPECT_EQ(crossed({roof(0.25), upon}, 1), Crossed::kUnclear);
}

TEST(CrossingArcs, ThreePiecesThatMeetInAPointBoundADisk) {
  const std::vector<Mesh> corner = {below(0, 0.11, 1.5), below(1, 0.12, 1.55), below(2, 0.13, 1.6)};
  EXPECT_EQ(crossed(corner, 3), Crossed::kDisks);
  EXPECT_EQ(crossed(corner, 3, true), Crossed::kUnclear) << "four sheets meet along each curve";
}

// In the middle of some of the curves the third piece hides that the boundary turns there.
TEST(CrossingArcs, APointWhereThreePiecesMeetIsFoundFarFromTheMiddleOfTheirCurves) {
  EXPECT_EQ(crossed({below(0, -0.51, 1.5), below(1, -0.52, 1.55), below(2, 0.83, 1.6)}, 3),
            Crossed::kDisks);
  EXPECT_EQ(crossed({below(0, 0.81, 1.5), below(1, 0.82, 1.55), below(2, -0.53, 1.6)}, 3),
            Crossed::kDisks);
}

// Two walls and two floors meet in four points, one on each pair of curves.
TEST(CrossingArcs, SeveralPointsAskForSmallerCells) {
  EXPECT_EQ(crossed({below(0, 0.11, 1.5), below(1, 0.12, 1.55), below(2, 0.13, 1.6),
                     below(2, -0.53, 1.65)},
                    4),
            Crossed::kTooMuch);
}

}  // namespace
}  // namespace kdm
