// SPDX-License-Identifier: MIT
// Scaling by powers of two, of coordinates of any size.
#include "mesh/scale.h"

#include <gtest/gtest.h>

#include <cmath>

namespace kdm {
namespace {

// Products with one factor would overflow or lose digits where the factor does.
TEST(Scale, MovesTheExponentOnly) {
  const std::vector<Vec3> positions = {
      {1, -3, 0}, {1e-300, -5e-324, 1.7e-310}, {1e300, 0.1, -7e22}, {0x1p-1022, -0x1p1000, 3}};
  for (const int exponent : {0, 1, -7, 900, -900, 1023, 1024, 2000, -1022, -1023, -2000}) {
    const std::vector<Vec3> moved = scaled(positions, exponent);
    ASSERT_EQ(moved.size(), positions.size());
    for (std::size_t i = 0; i < positions.size(); ++i) {
      for (int axis = 0; axis < 3; ++axis) {
        EXPECT_EQ(moved[i][axis], std::ldexp(positions[i][axis], exponent)) << exponent;
      }
    }
  }
}

}  // namespace
}  // namespace kdm
