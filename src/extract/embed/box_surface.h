// SPDX-License-Identifier: MIT
// The surface of a box, triangulated with closed curves on it as edges.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "geometry/lattice.h"

namespace kdm {

/// A closed walk over points, by number; the first follows the last.
using Curve = std::vector<Index>;

struct BoxSurface {
  std::vector<Vec3> points;         ///< those given, then the corners of the box
  std::vector<Triangle> triangles;  ///< counter-clockwise seen from outside

  /// The same on the side of a curve that is turned away from the largest part of the surface.
  struct Cap {
    std::vector<Index> triangles;
    bool left = false;  ///< the side lies left of the curve, seen from outside
    int level = 1;      ///< greater than that of all curves within the cap
  };
  std::vector<Cap> caps;  ///< per curve
  int levels = 1;         ///< the largest
};

/// `points` lie on the sides of the box exactly, `curves` are simple and disjoint and each of their
/// edges lies in one side, along none of the box's edges. Nothing if it is otherwise.
std::optional<BoxSurface> triangulate_box(const Vec3& lo, const Vec3& hi, std::vector<Vec3> points,
                                          const std::vector<Curve>& curves);

}  // namespace kdm
