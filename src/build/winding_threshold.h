// SPDX-License-Identifier: MIT
// Which winding numbers are inside, chosen from the surface itself.
#pragma once

#include <span>

#include "build/winding_field.h"
#include "geometry/lattice.h"

namespace kdm {

/// Of the thresholds 0.5, 0.45, ..., 0.1 the highest that keeps, but for a hundredth of the whole
/// area, as much of the triangles' area as any of them does. A face is kept if its winding number
/// is above the threshold behind it and not above it in front. Higher ones are never chosen: they
/// would keep what is inside at the price of opening what holds it.
double choose_winding_threshold(const WindingField& field,
                                std::span<const LatticeTriangle> triangles);

}  // namespace kdm
