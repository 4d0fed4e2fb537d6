// SPDX-License-Identifier: MIT
// Finds which triangles must be turned so that neighbours agree: they run along their common edge
// in opposite directions.
#pragma once

#include <span>
#include <vector>

#include "mesh/marks.h"
#include "mesh/numbers.h"
#include "mesh/topology.h"

namespace kdm {

/// A part of the mesh, joined by edges. It faces the way in which most of its area faced before.
struct PartDirection {
  TriangleId first = kNone;  ///< the lowest of its triangles
  Index triangles = 0;       ///< how many triangles it has, copies among them
  double area = 0;           ///< of its triangles without copies, in squared units of the points
  double agreeing = 0;       ///< area of the triangles that need not be turned: half or more
  bool closed = true;        ///< once turned, it uses every edge equally often both ways
  bool oriented = true;      ///< its triangles agreed before
  bool orientable = true;    ///< no two neighbours disagree once it is turned
};

struct NeighbourDirections {
  Marks must_turn;          ///< the triangles that must be turned
  std::vector<Index> part;  ///< for each triangle the number of its part
  /// For each triangle the first one over the same three points; kNone if it is the first one
  /// itself. Such a copy comes to face the same way as the first one and belongs to the same part.
  std::vector<TriangleId> copy_of;
  std::vector<PartDirection> parts;  ///< in order of their first triangles
  Index contradictions = 0;          ///< edges whose two triangles cannot agree (Moebius strips)
};

/// Finds the parts of a mesh and which triangles must be turned for neighbours to agree.
///
/// Triangles belong to one part if they are joined by edges of exactly two triangles, where copies
/// count once: an edge of more triangles does not tell which of them continue each other. Where the
/// triangles of a part disagree, they form two groups that face opposite ways, and the group of
/// less area is turned. Where a part cannot be oriented, neighbours still disagree on some edges
/// after turning (`contradictions`); these are edges on which they disagreed before, and are chosen
/// to be short.
///
/// `points` must be scaled so that squares of areas neither overflow nor underflow. `topology` must
/// be that of the triangles. Takes time n log n in the edges that disagree, else linear.
NeighbourDirections orient_neighbours(std::span<const Triangle> triangles,
                                      const std::vector<Vec3>& points, const Topology& topology);

}  // namespace kdm
