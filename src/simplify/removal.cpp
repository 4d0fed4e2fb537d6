// SPDX-License-Identifier: MIT
// Follows rows of triangles, joins loops and changes links.
#include "simplify/removal.h"

#include <algorithm>

#include "geometry/assert.h"

namespace kdm {

Index Removal::local_of(LoopId v) {
  if (local_[v] == kNone) {
    local_[v] = static_cast<Index>(loops_.size());
    up_.push_back(local_[v]);
    loops_.push_back(v);
  }
  return local_[v];
}

Index Removal::root_of(Index i) const {
  while (up_[i] != i) i = up_[i];
  return i;
}

void Removal::look_at(CellId cell) {
  KDM_ASSERT(work_.is_minimal(cell), "splits are removed from the leaves on");
  cell_ = cell;
  const SplitId split = work_.grid.cells[cell].split();
  first_ = work_.grid.edge_begin[4 * split];
  beyond_ = work_.grid.edge_begin[4 * split + 4];
  find_pieces();
  find_rows();
  for (const LoopId v : loops_) local_[v] = kNone;
}

void Removal::find_pieces() {
  loops_.clear();
  up_.clear();
  pieces_.clear();
  for (HitId h = first_; h < beyond_; ++h) {
    const Index a = root_of(local_of(work_.loop[work_.from_below(h)]));
    const Index b = root_of(local_of(work_.loop[work_.from_above(h)]));
    up_[std::max(a, b)] = std::min(a, b);
  }
  piece_.assign(loops_.size(), kNone);
  for (Index i = 0; i < loops_.size(); ++i) {
    const Index root = root_of(i);
    if (root == i) {
      piece_[i] = static_cast<Index>(pieces_.size());
      pieces_.emplace_back();
    }
    pieces_[piece_[root]].loops.push_back(loops_[i]);
  }
  for (HitId h = first_; h < beyond_; ++h) {
    JoinedPiece& piece = pieces_[piece_[root_of(local_[work_.loop[work_.from_below(h)]])]];
    piece.gone.push_back(h);
    const HalfEdgeId opposite = work_.grid.opposite[3 * h];
    if (opposite == kNone || 3 * h < opposite) ++piece.links;
  }
}

void Removal::find_rows() {
  rows_.clear();
  visited_.assign(beyond_ - first_);
  for (HitId h = first_; h < beyond_; ++h) {
    for (const HalfEdgeId side : {3 * h + 1, 3 * h + 2}) {
      const HalfEdgeId end = work_.grid.opposite[side];
      if (!visited_.test(h - first_) && (end == kNone || !removed(end))) find_row(side);
    }
  }
  for (HitId h = first_; h < beyond_; ++h) {
    if (visited_.test(h - first_)) continue;
    ++pieces_[piece_[root_of(local_[work_.loop[work_.from_below(h)]])]].closed_rows;
    for (HitId at = h; !visited_.test_and_set(at - first_);) {
      at = work_.grid.opposite[3 * at + 1] / 3;
    }
  }
}

// Follows a row from its first side on.
void Removal::find_row(HalfEdgeId side) {
  const std::vector<HalfEdgeId>& opposite = work_.grid.opposite;
  RemovedRow row;
  row.piece = piece_[root_of(local_[work_.loop[work_.from_below(side / 3)]])];
  row.beyond = work_.loop[work_.from_beyond(side / 3)];
  row.sides[0] = side;
  row.ends[0] = opposite[side];
  for (HalfEdgeId in = side;;) {
    KDM_ASSERT(in % 3 != 0, "rows pass the faces towards the third leaf");
    visited_.set(in / 3 - first_);
    row.hits.push_back(in / 3);
    const HalfEdgeId out = 3 * (in / 3) + 3 - in % 3;
    in = opposite[out];
    if (in != kNone && removed(in)) continue;
    row.sides[1] = out;
    row.ends[1] = in;
    break;
  }
  rows_.push_back(std::move(row));
}

bool Removal::keeps_topology() const {
  return std::all_of(pieces_.begin(), pieces_.end(), [](const JoinedPiece& piece) {
    return piece.loops.size() + piece.closed_rows == std::size_t{piece.links} + 1;
  });
}

bool Removal::try_links() {
  for (const RemovedRow& row : rows_) {
    // A vertex that is split by its hits must keep them, or become part of another.
    if (work_.split.test(row.beyond)) return false;
  }
  for (const RemovedRow& row : rows_) {
    for (const int i : {0, 1}) {
      if (row.ends[i] != kNone) work_.grid.opposite[row.ends[i]] = row.ends[1 - i];
    }
  }
  if (find_rings()) return true;
  undo_links();
  return false;
}

void Removal::undo_links() {
  for (const RemovedRow& row : rows_) {
    for (const int i : {0, 1}) {
      if (row.ends[i] != kNone) work_.grid.opposite[row.ends[i]] = row.sides[i];
    }
  }
}

// Tells whether a ring has enough triangles: three, or on the boundary one.
bool Removal::is_wide(HalfEdgeId start) const {
  HalfEdgeId at = start;
  for (int i = 0; i < 3; ++i) {
    at = work_.next_in_ring(at);
    if (at == kNone) return true;
    if (at == start) return i == 2;
  }
  return true;
}

bool Removal::find_rings() {
  for (JoinedPiece& piece : pieces_) piece.ring.clear();
  for (const RemovedRow& row : rows_) {
    JoinedPiece& piece = pieces_[row.piece];
    for (const HalfEdgeId end : row.ends) {
      if (end == kNone) continue;
      if (row.ends[0] / 3 == row.ends[1] / 3) return false;
      const bool from_beyond = work_.loop[end] == row.beyond;
      const HalfEdgeId next = work_.next(end);
      if (!is_wide(from_beyond ? end : next)) return false;
      HalfEdgeId start = from_beyond ? next : end;
      if (piece.ring.empty()) {
        if (!is_wide(start)) return false;
        for (HalfEdgeId at = start, before; (before = work_.previous_in_ring(at)) != kNone;) {
          at = before;
          if (at == start) break;
          if (work_.previous_in_ring(at) == kNone) start = at;
        }
        HalfEdgeId at = start;
        do {
          piece.ring.push_back(at);
          at = work_.next_in_ring(at);
        } while (at != kNone && at != start);
      } else if (std::find(piece.ring.begin(), piece.ring.end(), start) == piece.ring.end()) {
        return false;
      }
    }
  }
  return std::none_of(pieces_.begin(), pieces_.end(),
                      [](const JoinedPiece& piece) { return piece.ring.empty(); });
}

void Removal::finish(std::span<const Vec3> positions) {
  for (const RemovedRow& row : rows_) {
    work_.ring_changed.set(row.beyond);
    for (const HalfEdgeId end : row.ends) {
      if (end == kNone) continue;
      work_.relinked.set(end);
      work_.grid.start[end] &= ~GridData::kStrip;  // the face has become wider
    }
  }
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    const JoinedPiece& piece = pieces_[i];
    const LoopId v = *std::min_element(piece.loops.begin(), piece.loops.end());
    PrimalQuadric sum(positions[i]);
    for (const LoopId loop : piece.loops) sum.add(work_.planes[loop]);
    work_.planes[v] = sum;
    work_.position[v] = positions[i];
    work_.joined.set(v);
    for (const HalfEdgeId h : piece.ring) work_.loop[h] = v;
  }
  remove_split(work_.grid, cell_, work_.merged_cells);
}

}  // namespace kdm
