// SPDX-License-Identifier: MIT
// Parts of a mesh: triangles joined across their sides.
#pragma once

#include <span>
#include <vector>

#include "mesh/disjoint_sets.h"
#include "mesh/numbers.h"

namespace kdm {

/// Joins triangles across the sides that have an opposite (`kNone`: none); there are three sides a
/// triangle.
DisjointSets join_triangles(std::span<const SideId> opposite);

/// Returns for each of the numbers below `size` the number of its set; sets are numbered by their
/// lowest numbers.
std::vector<Index> number_sets(DisjointSets& sets, std::size_t size);

}  // namespace kdm
