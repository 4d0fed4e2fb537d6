// SPDX-License-Identifier: MIT
// Finds thin closed parts that cross or touch, such as the bars of a basket.
#pragma once

#include <vector>

#include "kdmanifold/mesh.h"
#include "prepare/faces.h"

namespace kdm {

/// Thin parts that meet, and what they can be built by.
struct ThinGroup {
  Index parts = 0;
  Mesh mesh;             ///< these parts, in model units
  double thickness = 0;  ///< the least mean thickness of the parts, in model units
};

/// Groups of thin parts.
struct ThinGroups {
  std::vector<Index> part_of;   ///< per triangle of the faces
  std::vector<Index> group_of;  ///< per part, kNone if it is in none
  std::vector<ThinGroup> groups;
  bool some_inside_out = false;  ///< some part of the faces encloses a negative volume: a cavity,
                                 ///< or a part that is inside out
};

/// Finds the thin parts of closed faces (see construct/exact_parts.h) that cross or touch each
/// other or themselves, and those so near to them that what is built of one might meet the other.
/// `tolerance` is in model units. Leaves out
/// - groups that lie within two tolerances of parts that are not thin, as those go through cells,
/// - groups of parts that closed holes were part of,
/// - the longest groups, once the others take 10,000 cells as long as they are thick.
///
/// Where nothing is thin, this takes one pass over the triangles.
ThinGroups find_thin_groups(const InputFaces& faces, double tolerance);

}  // namespace kdm
