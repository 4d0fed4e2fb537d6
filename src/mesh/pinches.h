// SPDX-License-Identifier: MIT
// Finds where a surface is joined to more than the neighbours of its triangles.
#pragma once

#include <span>

#include "mesh/marks.h"
#include "mesh/topology.h"

namespace kdm {

/// Marks the triangles of a closed surface with a side on an edge of three or more triangles, or
/// with a corner at a point where the triangles that are joined by sides form several fans.
/// `points` is above all corner numbers. The topology must be that of the triangles, and each side
/// must have an opposite. Takes linear time.
Marks find_pinched(std::span<const Triangle> triangles, Index points, const Topology& topology);

}  // namespace kdm
