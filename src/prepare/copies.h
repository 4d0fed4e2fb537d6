// SPDX-License-Identifier: MIT
// Parts of a closed surface that are there several times.
#pragma once

#include <span>

#include "mesh/marks.h"
#include "mesh/topology.h"

namespace kdm {

/// Marks the further copies of parts whose triangles all lie over the same points, and face the
/// same way, as many times: twice each, for instance. A part is what edges of any kind join. The
/// first triangle over each three points stays; without the others the solid is the same. If two
/// copies cancel, as where only odd winding numbers are inside, nothing stays of a part that is
/// there an even number of times. Other parts are left as they are. Takes linear time if no point
/// has very many triangles.
Marks find_copies(std::span<const Triangle> triangles, Index points, const Topology& topology,
                  bool two_cancel);

}  // namespace kdm
