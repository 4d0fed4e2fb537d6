// SPDX-License-Identifier: MIT
// Coordinates of about 1, for exact arithmetic whose products must stay in range.
#pragma once

#include <vector>

#include "kdmanifold/types.h"

namespace kdm {

struct ScaledPositions {
  std::vector<Vec3> positions;  ///< at most 1: the given ones times 2^-exponent
  int exponent = 0;
};

/// Rounds nothing, as long as coordinates do not differ by factors of 1e300.
ScaledPositions scale_to_one(const std::vector<Vec3>& positions);

}  // namespace kdm
