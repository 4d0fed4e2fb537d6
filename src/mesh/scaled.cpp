// SPDX-License-Identifier: MIT
// Exponents by frexp, factors by ldexp: both are exact.
#include "mesh/scaled.h"

#include <algorithm>
#include <cmath>

namespace kdm {

int exponent_of(const std::vector<Vec3>& points, std::span<const Triangle> triangles) {
  double largest = 0;
  for (const Triangle& t : triangles) {
    for (const Index corner : t) largest = std::max(largest, points[corner].cwiseAbs().maxCoeff());
  }
  int exponent = 0;
  std::frexp(largest, &exponent);
  return exponent;
}

std::vector<Vec3> scaled(const std::vector<Vec3>& points, int exponent) {
  std::vector<Vec3> result;
  result.reserve(points.size());
  for (const Vec3& p : points) {
    result.emplace_back(std::ldexp(p[0], exponent), std::ldexp(p[1], exponent),
                        std::ldexp(p[2], exponent));
  }
  return result;
}

}  // namespace kdm
