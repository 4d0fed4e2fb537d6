// SPDX-License-Identifier: MIT
// Coordinates of about 1, for exact arithmetic whose products must stay in range.
#pragma once

#include <span>
#include <vector>

#include "kdmanifold/types.h"

namespace kdm {

struct ScaledPositions {
  std::vector<Vec3> positions;  ///< at most 1: the given ones times 2^-exponent
  int exponent = 0;
};

/// Rounds nothing, as long as coordinates do not differ by factors of 1e300.
ScaledPositions scale_to_one(const std::vector<Vec3>& positions);

/// The same by the corners of these triangles: positions that none uses may lie anywhere.
ScaledPositions scale_to_one(const std::vector<Vec3>& positions,
                             std::span<const Triangle> triangles);

/// Each times 2^exponent.
std::vector<Vec3> scaled(const std::vector<Vec3>& positions, int exponent);

}  // namespace kdm
