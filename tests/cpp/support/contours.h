// SPDX-License-Identifier: MIT
// Closed curves on a box.
#pragma once

#include <cstdint>

#include "extract/embed/box_surface.h"

namespace kdm::check {

struct Contours {
  Vec3 lo;
  Vec3 hi;
  std::vector<Vec3> points;
  std::vector<Curve> curves;
};

/// Where random signs at points of the box's surface change: simple curves that keep apart, side by
/// side and within each other. The box's edges are of `size` steps, one point each.
Contours random_contours(int size, std::uint32_t seed);

}  // namespace kdm::check
