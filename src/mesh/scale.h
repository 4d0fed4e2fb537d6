// SPDX-License-Identifier: MIT
// Scales coordinates to about 1, for arithmetic whose products must neither overflow nor underflow.
#pragma once

#include <span>
#include <vector>

#include "kdmanifold/types.h"

namespace kdm {

/// Positions times a power of two, so that no coordinate exceeds 1.
struct ScaledPositions {
  std::vector<Vec3> positions;  ///< the given ones times 2^-exponent
  int exponent = 0;
};

/// Scales positions by a power of two so that the largest coordinate of all is about 1. Nothing is
/// rounded, as long as coordinates do not differ by factors of 1e300.
ScaledPositions scale_to_one(const std::vector<Vec3>& positions);

/// Scales positions by a power of two so that the largest coordinate of the triangles' corners is
/// about 1. Positions that no triangle uses may come out larger than 1.
ScaledPositions scale_to_one(const std::vector<Vec3>& positions,
                             std::span<const Triangle> triangles);

/// Returns each position times 2^exponent.
std::vector<Vec3> scaled(const std::vector<Vec3>& positions, int exponent);

}  // namespace kdm
