// SPDX-License-Identifier: MIT
#include "geometry/lattice.h"

#include <gtest/gtest.h>

#include <random>

namespace kdm {
namespace {

Box box_of(const Vec3& min, const Vec3& max) {
  Box box;
  box.min = min;
  box.max = max;
  return box;
}

TEST(Lattice, PutsTheMeshInTheMiddleWithAMargin) {
  const Lattice lattice = lattice_over(box_of(Vec3(-3, 10, 100), Vec3(5, 11, 104)));
  const LatticePoint lo = lattice.quantise(Vec3(-3, 10, 100));
  const LatticePoint hi = lattice.quantise(Vec3(5, 11, 104));
  EXPECT_EQ(lo[0], kLatticeMargin);
  EXPECT_EQ(hi[0], kLatticeSize - kLatticeMargin);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(lo[axis] + hi[axis], kLatticeSize, 1);
    EXPECT_GE(lo[axis], kLatticeMargin);
    EXPECT_LE(hi[axis], kLatticeSize - kLatticeMargin);
  }
}

TEST(Lattice, RoundsToTheNearestPointOfTheSameStepOnEveryAxis) {
  const Box box = box_of(Vec3(1e3, -2e3, 0.125), Vec3(1.5e3, 7e3, 0.25));
  const Lattice lattice = lattice_over(box);
  EXPECT_NEAR(lattice.step, 9e3 / (kLatticeSize - 2 * kLatticeMargin), 1e-9);
  std::mt19937 engine(1);
  const auto random = [&] { return static_cast<double>(engine()) / 4294967296.0; };
  for (int i = 0; i < 10000; ++i) {
    Vec3 p;
    for (int axis = 0; axis < 3; ++axis) {
      p[axis] = box.min[axis] + random() * (box.max[axis] - box.min[axis]);
    }
    const LatticePoint q = lattice.quantise(p);
    const Vec3 back = lattice.to_model(Vec3(q[0], q[1], q[2]));
    EXPECT_LE((back - p).cwiseAbs().maxCoeff(), 0.5000001 * lattice.step);
  }
}

TEST(Lattice, KeepsTheOrderOfCoordinates) {
  const Lattice lattice = lattice_over(box_of(Vec3::Zero(), Vec3::Constant(1e-30)));
  std::int32_t last = 0;
  for (int i = 0; i <= 1000; ++i) {
    const LatticePoint p = lattice.quantise(Vec3::Constant(1e-33 * i));
    EXPECT_GE(p[0], last);
    last = p[0];
  }
  EXPECT_EQ(last, kLatticeSize - kLatticeMargin);
}

TEST(Lattice, StaysInsideTheRootForExtremeBounds) {
  for (const double size : {1e-300, 1e-12, 1.0, 1e12, 1e300}) {
    for (const double offset : {0.0, 0.3, -17.0}) {
      const Vec3 min = Vec3::Constant(offset * size);
      const Vec3 max = min + Vec3(size, size / 3, 0);
      const Lattice lattice = lattice_over(box_of(min, max));
      for (const Vec3& p : {min, max}) {
        for (const std::int32_t x : lattice.quantise(p)) {
          EXPECT_GE(x, kLatticeMargin - 1) << "size " << size << " offset " << offset;
          EXPECT_LE(x, kLatticeSize - kLatticeMargin + 1) << "size " << size;
        }
      }
    }
  }
}

// Returns in which cell of the given width a mesh vertex lies, along one axis.
std::int32_t cell_of(std::int32_t coordinate, std::int32_t width) {
  return (coordinate - 1) / width;  // a plane's own vertices lie below it
}

TEST(Lattice, GivesTheLongestSideAnyNumberOfCells) {
  for (const int cells : {1, 2, 3, 5, 63, 64, 80, 127, 128, 165, 1000, 4096, 99999, 500000}) {
    for (const double offset : {0.0, -0.5, 1234.5}) {
      const Vec3 min(offset, 10 * offset, -offset);
      const Box box = box_of(min, min + Vec3(5, 7, 0.1));
      const Lattice lattice = lattice_of_cells(box, cells);
      const std::int32_t width = kLatticeSize >> halvings_for(cells);
      const LatticePoint lo = lattice.quantise(box.min);
      const LatticePoint hi = lattice.quantise(box.max);
      EXPECT_EQ(cell_of(hi[1], width) - cell_of(lo[1], width) + 1, cells) << offset;
      EXPECT_EQ(cell_of(lo[0], width), cell_of(lo[1], width));
      EXPECT_NEAR(lattice.step * width, 7.0 / cells, 3 * 7.0 / cells / cells / width);
      for (int axis = 0; axis < 3; ++axis) {
        EXPECT_GE(lo[axis], kLatticeMargin) << cells;
        EXPECT_LE(hi[axis], kLatticeSize - kLatticeMargin) << cells;
        EXPECT_NE(lo[axis] % width, 0);
      }
    }
  }
}

// A tree of twice as many cells an axis would waste a bit of each coordinate.
TEST(Lattice, HalvesTheRootNoOftenerThanCellsNeed) {
  EXPECT_EQ(halvings_for(1), 2);
  EXPECT_EQ(halvings_for(80), 7);
  EXPECT_EQ(halvings_for(126), 7);
  EXPECT_EQ(halvings_for(128), 8);
  EXPECT_EQ(halvings_for(500000), 19);
}

TEST(Lattice, TakesABoxWithoutExtent) {
  EXPECT_EQ(lattice_of_cells(box_of(Vec3(2, 3, 4), Vec3(2, 3, 4)), 80).step, 1.0);
  const Lattice lattice = lattice_over(box_of(Vec3(2, 3, 4), Vec3(2, 3, 4)));
  EXPECT_EQ(lattice.step, 1.0);
  EXPECT_EQ(lattice.quantise(Vec3(2, 3, 4)),
            (LatticePoint{kLatticeSize / 2, kLatticeSize / 2, kLatticeSize / 2}));
}

TEST(Lattice, AxesFollowEachOtherCyclically) {
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_EQ(next_axis(axis), (axis + 1) % 3);
    EXPECT_EQ(previous_axis(axis), (axis + 2) % 3);
  }
}

}  // namespace
}  // namespace kdm
