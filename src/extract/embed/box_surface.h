// SPDX-License-Identifier: MIT
// Divides the surface of a box into triangles such that given closed curves run along their edges,
// and finds the part of the surface that each curve cuts off.
#pragma once

#include <optional>
#include <vector>

#include "geometry/lattice.h"

namespace kdm {

/// A closed polygon, as the numbers of its points in turn; the first follows the last.
using Curve = std::vector<Index>;

/// The triangulated surface of a box, and the caps of the curves on it.
struct BoxSurface {
  std::vector<Vec3> points;         ///< the given points, then the eight corners of the box
  std::vector<Triangle> triangles;  ///< numbers of points, counter-clockwise seen from outside

  /// The part of the surface that a curve cuts off. The curves cut the surface into regions; the
  /// cap is the part on the side of the curve on which the largest region does not lie.
  struct Cap {
    std::vector<Index> triangles;  ///< numbers of triangles of the surface
    bool left = false;             ///< the cap lies to the left of the curve, seen from outside
    int level = 1;                 ///< 1 if no curves lie within the cap, else 1 more than the
                                   ///< greatest level of those
  };
  std::vector<Cap> caps;  ///< per curve
  int levels = 1;         ///< the greatest level of all caps
};

/// Triangulates the surface of the box from `lo` to `hi`. All `points` must lie exactly on its
/// sides. The curves must be simple and disjoint, and each of their edges must lie in one side of
/// the box, but not along an edge of the box. Returns nothing if that is not so. Takes time that
/// grows with the third power of the number of points on a side: meant for few points.
std::optional<BoxSurface> triangulate_box(const Vec3& lo, const Vec3& hi, std::vector<Vec3> points,
                                          const std::vector<Curve>& curves);

}  // namespace kdm
