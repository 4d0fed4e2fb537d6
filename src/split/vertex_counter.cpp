// SPDX-License-Identifier: MIT
#include "split/vertex_counter.h"

namespace kdm {

VertexCounter::VertexCounter(const Surface& surface) {
  PointId last = 0;
  for (const Triangle& t : surface.corners) last = std::max({last, t[0], t[1], t[2]});
  last_.assign(std::size_t{last} + 1, {});
  if (!surface.has_rims()) return;
  on_rim_.assign(std::size_t{last} + 1);
  for (SideId side = 0; side < surface.topology.opposite.size(); ++side) {
    if (surface.topology.opposite[side] != kNone) continue;
    const Triangle& t = surface.corners[triangle_of(side)];
    on_rim_.set(t[corner_of(side)]);
    on_rim_.set(t[next_corner(corner_of(side))]);
  }
}

Index VertexCounter::count_inner(const CellTriangles& triangles, std::span<const MemberId> members,
                                 std::span<const PieceId> piece_of) {
  const Surface& surface = triangles.surface();
  Index inner = 0;
  ++counts_;
  others_.clear();
  for (const MemberId member : members) {
    const TriangleId triangle = triangles.triangle(member);
    for (int i = 0; i < 3; ++i) {
      const PointId point = surface.corners[triangle][i];
      Met& met = last_[point];
      const PieceId piece = piece_of[member];
      if (met.count == counts_) {
        const std::pair pair(point, piece);
        if (met.piece == piece ||
            std::find(others_.begin(), others_.end(), pair) != others_.end()) {
          continue;
        }
        others_.push_back(pair);
      } else {
        if (triangles.outcodes(member)[i] != 0) continue;
        met = {counts_, piece};
      }
      if (on_rim_.empty() || !on_rim_.test(point)) ++inner;
    }
  }
  return inner;
}

}  // namespace kdm
