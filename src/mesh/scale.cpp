// SPDX-License-Identifier: MIT
// Coordinates of about 1, for exact arithmetic whose products must stay in range.
#include "mesh/scale.h"

#include <algorithm>
#include <cmath>

namespace kdm {

ScaledPositions scale_to_one(const std::vector<Vec3>& positions) {
  double largest = 0;
  for (const Vec3& p : positions) largest = std::max(largest, p.cwiseAbs().maxCoeff());
  ScaledPositions scaled;
  std::frexp(largest, &scaled.exponent);
  scaled.positions.reserve(positions.size());
  for (const Vec3& p : positions) {
    scaled.positions.emplace_back(std::ldexp(p[0], -scaled.exponent),
                                  std::ldexp(p[1], -scaled.exponent),
                                  std::ldexp(p[2], -scaled.exponent));
  }
  return scaled;
}

}  // namespace kdm
