// SPDX-License-Identifier: MIT
#include "split/pillow_search.h"

#include "geometry/triangle_box.h"

namespace kdm {

std::optional<PieceId> PillowSearch::find_pillow(const CellSurface& cell) {
  const std::span<const Piece> pieces = cell.pieces.all();
  for (PieceId i = 0; i < pieces.size(); ++i) {
    if (!pieces[i].hangs_on_one_edge()) continue;
    const TriangleId triangle = cell.triangles.triangle(pieces[i].lowest_member);
    if (part_is_closed_and_near(triangle, cell.triangles.cell())) return i;
  }
  return std::nullopt;
}

// Tells whether everything that is connected with the triangle is closed and lies no further from
// the cell than the cell is wide. Most searches end after a few steps.
bool PillowSearch::part_is_closed_and_near(TriangleId triangle, const LatticeBox& cell) {
  LatticeBox near = cell;
  for (int i = 0; i < 3; ++i) {
    near.lo[i] -= extent(cell, i);
    near.hi[i] += extent(cell, i);
  }
  last_search_.resize(surface_.triangles.size(), 0);
  ++searches_;
  to_visit_.assign(1, triangle);
  last_search_[triangle] = searches_;
  while (!to_visit_.empty()) {
    const TriangleId t = to_visit_.back();
    to_visit_.pop_back();
    for (const LatticePoint& p : surface_.triangles[t]) {
      if (!vertex_in_box(p, near)) return false;
    }
    for (SideId side = 3 * t; side < 3 * t + 3; ++side) {
      if (surface_.topology.opposite[side] == kNone) return false;
      const TriangleId neighbour = triangle_of(surface_.topology.opposite[side]);
      if (last_search_[neighbour] == searches_) continue;
      last_search_[neighbour] = searches_;
      to_visit_.push_back(neighbour);
    }
  }
  return true;
}

}  // namespace kdm
