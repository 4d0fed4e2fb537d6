// SPDX-License-Identifier: MIT
#include "split/member_groups.h"

#include <algorithm>

#include "geometry/triangle_box.h"

namespace kdm {

void MemberGroups::connect(const CellTriangles& triangles, std::span<const MemberId> subset,
                           const LatticeBox& box) {
  const std::vector<SideId>& opposites = triangles.surface().topology.opposite;
  parent_.assign(triangles.size(), kNone);
  for (const MemberId m : subset) parent_[m] = m;
  count_ = static_cast<Index>(subset.size());
  shared_edges_ = 0;
  rim_sides_.clear();
  for (const MemberId m : subset) {
    const TriangleId triangle = triangles.triangle(m);
    const LatticeTriangle& corners = triangles.corners(m);
    for (int i = 0; i < 3; ++i) {
      const SideId side = 3 * triangle + static_cast<Index>(i);
      const SideId opposite = opposites[side];
      // Of the two sides of an edge only the lower one is looked at; kNone is above all.
      if (opposite < side || !edge_meets_box(corners[i], corners[next_corner(i)], box)) continue;
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
