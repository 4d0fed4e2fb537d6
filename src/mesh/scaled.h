// SPDX-License-Identifier: MIT
// Points scaled by a power of two, which rounds nothing, so that products of coordinates stay in
// range.
#pragma once

#include <span>
#include <vector>

#include "kdmanifold/types.h"

namespace kdm {

/// The least e so that all coordinates of the triangles' corners are below 2^e in size; points
/// that no triangle uses may lie anywhere. 0 if all are 0.
int exponent_of(const std::vector<Vec3>& points, std::span<const Triangle> triangles);

/// Each coordinate times 2^exponent.
std::vector<Vec3> scaled(const std::vector<Vec3>& points, int exponent);

}  // namespace kdm
