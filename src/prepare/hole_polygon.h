// SPDX-License-Identifier: MIT
// Measures the outline of a hole.
#pragma once

#include <span>
#include <vector>

#include "mesh/numbers.h"

namespace kdm {

/// The outline of a hole, in the direction of the patch that closes it: against that of the sides
/// at the hole.
struct HolePolygon {
  std::vector<PointId> corners;
  /// For each edge, from its corner to the next one, the normal of the mesh's triangle there.
  std::vector<Vec3> beyond;
  Vec3 centre = Vec3::Zero();  ///< the mean of the corners
  Vec3 normal = Vec3::Zero();  ///< unit vector along the area vector; zero if there is no area
  double area = 0;             ///< length of the area vector (Newell's normal)
  double deviation = 0;        ///< how far corners are from the plane through the centre, at most
  Box bounds;
};

/// Measures the outline of a hole, given by its sides (see prepare/holes.h). `points` must be
/// scaled to about 1.
HolePolygon measure_hole(std::span<const SideId> sides, std::span<const Triangle> triangles,
                         const std::vector<Vec3>& points);

}  // namespace kdm
