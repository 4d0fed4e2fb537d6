// SPDX-License-Identifier: MIT
#include "split/cell_pieces.h"

#include <algorithm>
#include <numeric>

namespace kdm {

void CellPieces::find(const CellTriangles& triangles, const CellCrossings& crossings) {
  all_members_.resize(triangles.size());
  std::iota(all_members_.begin(), all_members_.end(), MemberId{0});
  groups_.connect(triangles, all_members_);
  pieces_.clear();
  pieces_.reserve(groups_.count());
  piece_of_.resize(triangles.size());
  for (const MemberId m : all_members_) {
    const MemberId lowest = groups_.lowest(m);
    if (lowest == m) {
      piece_of_[m] = static_cast<PieceId>(pieces_.size());
      pieces_.push_back({.lowest_member = m, .bounds = triangles.bounds(m)});
    } else {
      piece_of_[m] = piece_of_[lowest];
      widen(pieces_[piece_of_[m]].bounds, triangles.bounds(m));
    }
  }
  count(triangles);
  for (const SideId side : rim_sides()) {
    const TriangleId triangle = triangle_of(side);
    Piece& piece = pieces_[piece_of_[triangles.member_of(triangle)]];
    ++piece.rims;
    // Each vertex of the rim is where one of its sides starts.
    if (triangles.outcodes(triangles.member_of(triangle))[corner_of(side)] == 0) --piece.rims;
  }
  for (const CellCrossing& crossing : crossings.all) {
    const MemberId m = triangles.member_of(crossing.triangle);
    if (m == kNone) continue;
    Piece& piece = pieces_[piece_of_[m]];
    ++piece.crossings;
    piece.kept += crossing.kept ? 1 : 0;
    piece.inner += crossing.inner ? 1 : 0;
    piece.edges |= 1u << crossing.edge;
  }
}

bool CellPieces::are_disks() const {
  if (euler_characteristic_ != std::int64_t{bounding_}) return false;
  return std::all_of(pieces_.begin(), pieces_.end(), [](const Piece& piece) {
    return piece.is_inner || (piece.crossings > 0 && piece.rims <= 1);
  });
}

void CellPieces::leave_inner_out(const CellTriangles& triangles) {
  all_members_.clear();
  for (MemberId m = 0; m < triangles.size(); ++m) {
    if (!pieces_[piece_of_[m]].is_inner) all_members_.push_back(m);
  }
  groups_.connect(triangles, all_members_);
  count(triangles);
}

void CellPieces::count(const CellTriangles& triangles) {
  bounding_ = groups_.count();
  euler_characteristic_ = std::int64_t{vertices_.count_inner(triangles, all_members_, piece_of_)} -
                          std::int64_t{groups_.shared_edges()} +
                          static_cast<std::int64_t>(all_members_.size());
}

}  // namespace kdm
