// SPDX-License-Identifier: MIT
// Measures how large a model is, without parts that lie astray.
#pragma once

#include <span>
#include <vector>

#include "kdmanifold/types.h"
#include "mesh/topology.h"

namespace kdm {

/// How large a model is.
struct Extent {
  double diagonal = 0;    ///< of the bounding box without stray parts
  Index stray_parts = 0;  ///< how many there are
};

/// Measures the triangles, whose bounding box is `bounds`. Stray parts are the smallest parts,
/// joined by points, that have less than a thousandth of the area together, provided that the
/// diagonal without them is less than half of that with them. Takes linear time, but for sorting
/// parts.
Extent find_extent(std::span<const Triangle> triangles, const std::vector<Vec3>& points,
                   const Topology& topology, const Box& bounds);

}  // namespace kdm
