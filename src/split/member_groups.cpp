// SPDX-License-Identifier: MIT
#include "split/member_groups.h"

#include <algorithm>

#include "geometry/triangle_box.h"

namespace kdm {

void MemberGroups::connect(const CellTriangles& triangles, std::span<const MemberId> subset) {
  join_where(triangles, subset, [&](MemberId m, int i) {
    return edge_meets_box(triangles.corners(m), triangles.outcodes(m), i, triangles.cell());
  });
}

void MemberGroups::connect_on_face(const CellTriangles& triangles, std::span<const MemberId> subset,
                                   int axis, bool high) {
  const LatticeBox face = triangles.face(axis, high);
  join_where(triangles, subset, [&](MemberId m, int i) {
    return edge_meets_box(triangles.corners(m), triangles.outcodes_at_face(m, axis, high), i, face);
  });
}

// Joins members where `meets(m, i)` says that the mesh edge from corner i of m counts.
template <typename Meets>
void MemberGroups::join_where(const CellTriangles& triangles, std::span<const MemberId> subset,
                              const Meets& meets) {
  const std::vector<SideId>& opposites = triangles.surface().topology.opposite;
  parent_.assign(triangles.size(), kNone);
  for (const MemberId m : subset) parent_[m] = m;
  count_ = static_cast<Index>(subset.size());
  shared_edges_ = 0;
  rim_sides_.clear();
  for (const MemberId m : subset) {
    const TriangleId triangle = triangles.triangle(m);
    for (int i = 0; i < 3; ++i) {
      const SideId side = 3 * triangle + static_cast<Index>(i);
      const SideId opposite = opposites[side];
      // Of the two sides of an edge only the lower one is looked at; kNone is above all.
      if (opposite < side || !meets(m, i)) continue;
      if (opposite == kNone) {
        rim_sides_.push_back(side);
        continue;
      }
      ++shared_edges_;
      const MemberId neighbour = triangles.member_of(triangle_of(opposite));
      if (neighbour == kNone || !contains(neighbour)) continue;
      const MemberId a = lowest(m);
      const MemberId b = lowest(neighbour);
      if (a == b) continue;
      parent_[std::max(a, b)] = std::min(a, b);
      --count_;
    }
  }
}

}  // namespace kdm
