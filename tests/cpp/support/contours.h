// SPDX-License-Identifier: MIT
// Random closed curves on the surface of a box.
#pragma once

#include <cstdint>

#include "extract/embed/box_surface.h"

namespace kdm::check {

/// A box, points on its surface, and closed curves through them.
struct Contours {
  Vec3 lo;
  Vec3 hi;
  std::vector<Vec3> points;
  std::vector<Curve> curves;
};

/// Gives random signs to points on a box's surface, `size` steps to an edge, and returns the curves
/// along which the signs change. They do not meet themselves or each other, and lie side by side
/// and within each other.
Contours random_contours(int size, std::uint32_t seed);

}  // namespace kdm::check
