// SPDX-License-Identifier: MIT
// Finds polygons that are holes in other polygons of the same plane.
#pragma once

#include <vector>

#include "prepare/hole_polygon.h"

namespace kdm {

/// Groups flat polygons so that each group is one polygon with the holes in it, and returns the
/// groups: the outer polygon first, then the holes in ascending order. A polygon is a hole if the
/// smallest polygon of its plane that holds it runs round the other way and is no hole itself.
/// Polygons lie in one plane if all corners of the inner one are within `distance` of the plane of
/// the outer one. `points` are the positions of the corners, scaled to about 1.
///
/// The effort is limited to a second; what lies in what is then not found for the smaller polygons,
/// and each of these is a group of its own.
std::vector<std::vector<Index>> group_nested(const std::vector<HolePolygon>& polygons,
                                             const std::vector<Vec3>& points, double distance);

}  // namespace kdm
