// SPDX-License-Identifier: MIT
// Which gaps between two crossings of a grid edge are closed.
#include "inside/gaps.h"

#include <gtest/gtest.h>

#include "support/shapes.h"

namespace kdm {
namespace {

using shapes::box;

constexpr double kTolerance = 320;  // lattice units: gaps of 10 are closed between parts

// Leaves one box, or the arm of a hook, and enters the next along x, some lattice units on.
class TwoWalls {
 public:
  explicit TwoWalls(const Mesh& mesh) : surface_(prepare_surface(mesh)) {}

  bool closed(double gap, int axis = 0) const {
    std::vector<ClassifiedCrossing> edge;
    constexpr LinePosition kStart = 1000 << kFractionBits;
    edge.emplace_back(kStart, facing(1), 0, CrossingRole::kBounds, true);
    edge.emplace_back(kStart + static_cast<LinePosition>(gap / kFractionUnit), facing(-1), 1,
                      CrossingRole::kBounds, false);
    GapRule(surface_, kTolerance, true).close(axis, edge);
    EXPECT_EQ(edge[0].role(), edge[1].role());
    return edge[0].role() == CrossingRole::kGap;
  }

 private:
  // The triangle with this normal along x that is nearest to x = 0.
  TriangleId facing(double direction) const {
    TriangleId nearest = kNone;
    double least = kLatticeSize;
    const double middle = surface_.lattice.to_lattice(Vec3::Zero())[0];
    for (TriangleId t = 0; t < surface_.triangles.size(); ++t) {
      const double x = std::abs(surface_.triangles[t][0][0] - middle);
      if (surface_.planes[t].normal[0] * direction < 0.9 || x >= least) continue;
      least = x;
      nearest = t;
    }
    return nearest;
  }

  Surface surface_;
};

const Mesh kTwoBoxes =
    shapes::merged({box(Vec3(-1, 0, 0), Vec3(0, 1, 1)), box(Vec3(0.1, 0, 0), Vec3(1, 1, 1))});

TEST(Gaps, BetweenPartsAreClosedUpToAShareOfTheTolerance) {
  const TwoWalls walls(kTwoBoxes);
  EXPECT_TRUE(walls.closed(0));
  EXPECT_TRUE(walls.closed(9.9));
  EXPECT_FALSE(walls.closed(10.1));
}

TEST(Gaps, OfALatticeUnitOrTwoAreAlwaysClosed) { EXPECT_EQ(widest_gap(0), 4); }

// A grid edge along y nearly runs within the gap; its width across the gap counts.
TEST(Gaps, AreMeasuredAcross) { EXPECT_TRUE(TwoWalls(kTwoBoxes).closed(1000, 1)); }

// A box with a slit from above: both walls are of one part, and the slit is meant.
TEST(Gaps, WithinAPartAreClosedForRoundingOnly) {
  Mesh slit;
  const std::vector<std::array<double, 2>> outline{{-1, 0},    {1, 0},   {1, 1}, {0.1, 1},
                                                   {0.1, 0.5}, {0, 0.5}, {0, 1}, {-1, 1}};
  const auto n = static_cast<Index>(outline.size());
  for (const double y : {0.0, 1.0}) {
    for (const auto& [x, z] : outline) slit.positions.push_back({x, y, z});
  }
  for (Index i = 0; i < n; ++i) {
    const Index j = (i + 1) % n;
    slit.triangles.push_back({i, j, n + j});
    slit.triangles.push_back({i, n + j, n + i});
  }
  for (const auto& t : {Triangle{0, 5, 1}, {1, 5, 4}, {1, 4, 3}, {1, 3, 2}, {0, 7, 6}, {0, 6, 5}}) {
    slit.triangles.push_back(t);
    slit.triangles.push_back({n + t[0], n + t[2], n + t[1]});
  }
  const TwoWalls walls(slit);
  EXPECT_TRUE(walls.closed(3.9));
  EXPECT_FALSE(walls.closed(4.1));
}

}  // namespace
}  // namespace kdm
