// SPDX-License-Identifier: MIT
#include "split/contact_points.h"

#include <algorithm>

#include "geometry/quadric.h"

namespace kdm {

ContactPoints::ContactPoints(const Surface& surface) : surface_(surface) {
  PointId last = 0;
  for (const Triangle& t : surface.corners) last = std::max({last, t[0], t[1], t[2]});
  piece_at_.assign(std::size_t{last} + 1, kNone);
}

bool ContactPoints::exist_in(const CellSurface& cell, bool shells_touch) {
  if (!nothing_is_inner(cell)) return false;
  return (shells_touch || pieces_share_a_vertex(cell)) && planes_have_a_corner(cell);
}

bool ContactPoints::nothing_is_inner(const CellSurface& cell) {
  return std::all_of(cell.inner.begin(), cell.inner.end(),
                     [](const InnerPart& part) { return part.all || part.corners == 0; }) &&
         std::none_of(cell.crossings.all.begin(), cell.crossings.all.end(),
                      [](const CellCrossing& crossing) { return crossing.inner; });
}

bool ContactPoints::pieces_share_a_vertex(const CellSurface& cell) {
  if (cell.pieces.all().size() < 2) return false;
  for (const PointId point : points_met_) piece_at_[point] = kNone;
  points_met_.clear();
  for (MemberId m = 0; m < cell.triangles.size(); ++m) {
    const PieceId piece = cell.pieces.piece_of(m);
    if (cell.pieces.all()[piece].is_inner) continue;
    for (int i = 0; i < 3; ++i) {
      if (cell.is_inner(m) || cell.triangles.outcodes(m)[i] != 0) continue;
      const PointId point = surface_.corners[cell.triangles.triangle(m)][i];
      if (piece_at_[point] == kNone) {
        piece_at_[point] = piece;
        points_met_.push_back(point);
      } else if (piece_at_[point] != piece) {
        return true;
      }
    }
  }
  return false;
}

bool ContactPoints::planes_have_a_corner(const CellSurface& cell) const {
  PrimalQuadric quadric(Vec3::Zero());
  for (MemberId m = 0; m < cell.triangles.size(); ++m) {
    if (!cell.is_inner(m)) quadric.add(surface_.planes[cell.triangles.triangle(m)]);
  }
  return quadric.certainty().sum() > 2.5;
}

}  // namespace kdm
