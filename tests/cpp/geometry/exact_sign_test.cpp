// SPDX-License-Identifier: MIT
// Exact signs against integer arithmetic: 32-bit floats as multiples of a small power of two.
#include "geometry/exact_sign.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/random.h"

namespace kdm {
namespace {

using Wide = __int128;

int sign_of(Wide value) { return value > 0 ? 1 : (value < 0 ? -1 : 0); }

// Coordinates are `unit` times whole numbers of up to 40 bits.
int volume_oracle(const std::array<std::array<std::int64_t, 3>, 4>& p) {
  Wide r[3][3];
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) r[i][k] = p[i][k] - p[3][k];
  }
  Wide det = 0;
  for (int k = 0; k < 3; ++k) {
    det +=
        r[0][k] * (r[1][(k + 1) % 3] * r[2][(k + 2) % 3] - r[1][(k + 2) % 3] * r[2][(k + 1) % 3]);
  }
  return -sign_of(det);
}

Vec3 real(const std::array<std::int64_t, 3>& p, double unit) {
  return Vec3(static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])) *
         unit;
}

TEST(ExactSign, VolumesOfNearlyFlatTetrahedra) {
  check::Random random(3);
  std::array<int, 3> seen{};
  for (int i = 0; i < 200000; ++i) {
    const double unit = std::ldexp(1.0, static_cast<int>(random.below(60)) - 40);
    std::array<std::array<std::int64_t, 3>, 4> p{};
    // The fourth is a whole combination of the others, or next to one: flat, or nearly so. 36 bits.
    const std::int64_t range = std::int64_t{1} << (4 + random.below(30));
    const auto whole = [&] {
      const std::int64_t number = (std::int64_t{random.below(1u << 31)} << 8) | random.below(256);
      return number % (2 * range) - range;
    };
    for (int j = 0; j < 3; ++j) {
      for (int k = 0; k < 3; ++k) p[j][k] = whole();
    }
    for (int k = 0; k < 3; ++k) {
      p[3][k] = p[0][k] + p[1][k] - p[2][k] + static_cast<int>(random.below(3)) - 1;
      if (i % 2 == 0) p[3][k] = p[0][k] + p[1][k] - p[2][k];
    }
    const int expected = volume_oracle(p);
    ASSERT_EQ(volume_sign(real(p[0], unit), real(p[1], unit), real(p[2], unit), real(p[3], unit)),
              expected)
        << i;
    ++seen[expected + 1];
  }
  for (const int count : seen) EXPECT_GT(count, 10000);
}

TEST(ExactSign, AreasOfNearlyStraightTriangles) {
  check::Random random(4);
  std::array<int, 3> seen{};
  for (int i = 0; i < 200000; ++i) {
    const std::int64_t range = std::int64_t{1} << (2 + random.below(29));
    std::array<std::array<std::int64_t, 3>, 3> p{};
    for (int k = 0; k < 3; ++k) {
      p[0][k] = random.below(1u << 31) % range;
      p[1][k] = random.below(1u << 31) % range;
      p[2][k] = 2 * p[1][k] - p[0][k] + static_cast<int>(random.below(3)) - 1;
      if (i % 2 == 0) p[2][k] = 2 * p[1][k] - p[0][k];
    }
    for (int axis = 0; axis < 3; ++axis) {
      const int u = (axis + 1) % 3;
      const int v = (axis + 2) % 3;
      const int expected = sign_of(Wide{p[1][u] - p[0][u]} * (p[2][v] - p[0][v]) -
                                   Wide{p[1][v] - p[0][v]} * (p[2][u] - p[0][u]));
      ASSERT_EQ(area_sign(real(p[0], 0x1p-20), real(p[1], 0x1p-20), real(p[2], 0x1p-20), axis),
                expected);
      ++seen[expected + 1];
    }
  }
  for (const int count : seen) EXPECT_GT(count, 10000);
}

// Coordinates of very different size, where differences are rounded.
TEST(ExactSign, SmallBesideLarge) {
  const Vec3 a(1, 0, 0);
  const Vec3 b(0, 1, 0);
  const Vec3 c(0, 0, 1);
  // On the plane x + y + z = 1, and off it by what a double near 1 cannot hold.
  const double tiny = 0x1p-80;
  EXPECT_EQ(volume_sign(a, b, c, Vec3(0.5, 0.5, 0)), 0);
  EXPECT_EQ(volume_sign(a, b, c, Vec3(0.5, 0.5, tiny)), 1);
  EXPECT_EQ(volume_sign(a, b, c, Vec3(0.5, 0.5, -tiny)), -1);
}

}  // namespace
}  // namespace kdm
