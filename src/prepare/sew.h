// SPDX-License-Identifier: MIT
// Closes cracks by joining their rims.
#pragma once

#include <vector>

#include "mesh/topology.h"

namespace kdm {

/// Sews cracks: joins the ends of two rim sides that lie side by side, and returns how many pairs
/// of sides were joined. A rim side is a side of a triangle that is the only one along its edge.
/// Two of them belong together if each is the nearest to the other, and if their ends are no
/// further apart than `distance` and than half the shorter side; lengths are measured by the
/// largest difference of coordinates, in the units of `points`. Points that are joined become the
/// one with the lowest number, which moves to the mean of their positions; a triangle may come out
/// with equal corners. `topology` must be that of the triangles, and is kept so. Takes time n log n
/// in the rim sides.
Index sew_rims(double distance, std::vector<Triangle>& triangles, std::vector<Vec3>& points,
               Topology& topology);

/// Returns how far `sew_rims` must reach for a surface whose triangles are torn apart, `most` at
/// most; 0 if it is not torn. It is if more than a fifth of its edges are rim sides, and more than
/// half of these have a partner: each is the nearest to the other, within `most` and half the
/// shorter side, and their triangles lie away from each other. `topology` must be that of the
/// triangles. Takes time n log n in the rim sides.
double torn_distance(double most, const std::vector<Triangle>& triangles,
                     const std::vector<Vec3>& points, const Topology& topology);

}  // namespace kdm
