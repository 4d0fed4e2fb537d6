// SPDX-License-Identifier: MIT
// Surfaces whose every face has its back, like the assets of games.
#pragma once

#include <span>
#include <vector>

#include "mesh/disjoint_sets.h"
#include "mesh/marks.h"
#include "mesh/numbers.h"
#include "mesh/topology.h"

namespace kdm {

/// Marks the triangles of parts that have two sides: parts that consist of pairs of triangles back
/// to back, so that the other triangles of the part, if there are any, enclose next to nothing and
/// have the lesser area. `paired` marks the triangles of pairs (see prepare/cancel.h), `parts` says
/// which triangles are of one part. Parts with fewer than `fewest` triangles in pairs, which is 1
/// at least, do not count.
Marks find_two_sided_parts(std::span<const Triangle> triangles, const std::vector<Vec3>& points,
                           const Marks& paired, DisjointSets& parts, Index fewest);

/// Tells whether some part, joined by edges of any kind, has two sides. Its pairs must not be
/// dropped, since they bound what the part encloses. Parts with fewer than eight triangles in pairs
/// do not count: four on either side are the fewest that may enclose something.
bool some_part_has_two_sides(std::span<const Triangle> triangles, const std::vector<Vec3>& points,
                             const Topology& topology);

}  // namespace kdm
