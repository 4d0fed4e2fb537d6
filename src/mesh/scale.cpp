// SPDX-License-Identifier: MIT
// Scales coordinates by powers of two.
#include "mesh/scale.h"

#include <algorithm>
#include <cmath>

namespace kdm {

namespace {

// Returns the exponent of the power of two next above the number.
int exponent_of(double largest) {
  int exponent = 0;
  std::frexp(largest, &exponent);
  return exponent;
}

}  // namespace

std::vector<Vec3> scaled(const std::vector<Vec3>& positions, int exponent) {
  std::vector<Vec3> result;
  result.reserve(positions.size());
  const double factor = std::ldexp(1.0, exponent);
  const bool one_factor = std::isnormal(factor);  // not for extremely large or small positions
  for (const Vec3& p : positions) {
    if (one_factor) {
      result.emplace_back(p * factor);
    } else {
      result.emplace_back(std::ldexp(p[0], exponent), std::ldexp(p[1], exponent),
                          std::ldexp(p[2], exponent));
    }
  }
  return result;
}

ScaledPositions scale_to_one(const std::vector<Vec3>& positions) {
  double largest = 0;
  for (const Vec3& p : positions) largest = std::max(largest, p.cwiseAbs().maxCoeff());
  const int exponent = exponent_of(largest);
  return {scaled(positions, -exponent), exponent};
}

ScaledPositions scale_to_one(const std::vector<Vec3>& positions,
                             std::span<const Triangle> triangles) {
  double largest = 0;
  for (const Triangle& t : triangles) {
    for (const Index corner : t) {
      largest = std::max(largest, positions[corner].cwiseAbs().maxCoeff());
    }
  }
  const int exponent = exponent_of(largest);
  return {scaled(positions, -exponent), exponent};
}

}  // namespace kdm
