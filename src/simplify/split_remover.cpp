// SPDX-License-Identifier: MIT
// Keeps a heap of the splits, and does what a removal needs.
#include "simplify/split_remover.h"

#include <algorithm>
#include <tuple>

#include "mesh/sort.h"

namespace kdm {

// The standard library's heaps have the largest first.
bool SplitRemover::is_later(const Entry& a, const Entry& b) {
  return std::tie(a.cost, a.split, a.version) > std::tie(b.cost, b.split, b.version);
}

SplitRemover::SplitRemover(WorkGrid& work, NearSurface& near, double most_cost)
    : work_(work),
      near_(near),
      most_cost_(most_cost),
      removal_(work),
      version_(work.cell_of_split.size(), 0) {
  for (const CellId cell : work.cell_of_split) {
    if (work.is_minimal(cell)) push(cell);
  }
}

// Returns the hit at an end of the row that takes over its hits with the least error, and that
// error; kNone if both ends are on the boundary.
HitId SplitRemover::absorbing_hit(const RemovedRow& row, double& error) const {
  HitId best = kNone;
  error = 0;
  for (const HalfEdgeId end : row.ends) {
    if (end == kNone) continue;
    DualQuadric sum = work_.points[end / 3];
    for (const HitId h : row.hits) sum.add(work_.points[h]);
    const double here = sum.least_error();
    if (best != kNone && here >= error) continue;
    best = end / 3;
    error = here;
  }
  return best;
}

double SplitRemover::cost() const {
  double largest = 0;
  for (const RemovedRow& row : removal_.rows()) {
    double error;
    absorbing_hit(row, error);
    largest = std::max(largest, error);
  }
  return largest;
}

void SplitRemover::push(CellId cell) {
  const SplitId split = work_.grid.cells[cell].split();
  ++version_[split];  // what was found before counts no longer
  removal_.look_at(cell);
  if (!removal_.keeps_topology()) return;
  const double here = cost();
  if (here > most_cost_) return;
  heap_.push_back({here, split, version_[split]});
  std::push_heap(heap_.begin(), heap_.end(), is_later);
}

bool SplitRemover::remove_next() {
  while (!heap_.empty()) {
    std::pop_heap(heap_.begin(), heap_.end(), is_later);
    const Entry entry = heap_.back();
    heap_.pop_back();
    if (entry.version != version_[entry.split]) continue;
    const CellId cell = work_.cell_of_split[entry.split];
    if (!try_removal(cell)) continue;
    ++removed_;
    largest_cost_ = std::max(largest_cost_, entry.cost);
    return true;
  }
  return false;
}

bool SplitRemover::try_removal(CellId cell) {
  removal_.look_at(cell);
  if (!removal_.try_links()) return false;
  positions_.clear();
  for (const JoinedPiece& piece : removal_.pieces()) {
    Vec3 position;
    if (!near_.find_position(work_, piece, work_.boxes[cell], position)) {
      removal_.undo_links();
      return false;
    }
    positions_.push_back(position);
  }
  for (std::size_t i = 0; i < positions_.size(); ++i) {
    near_.move(work_, removal_.pieces()[i], positions_[i]);
  }
  for (const RemovedRow& row : removal_.rows()) {
    double error;
    const HitId hit = absorbing_hit(row, error);
    if (hit == kNone) continue;
    for (const HitId h : row.hits) work_.points[hit].add(work_.points[h]);
  }
  ++version_[work_.grid.cells[cell].split()];
  removal_.finish(positions_);
  push_neighbours(cell);
  return true;
}

// Notes the cells of the splits on whose edges the hits of a ring lie.
void SplitRemover::push_owners(HalfEdgeId start) {
  HalfEdgeId at = start;
  do {
    stale_.push_back(work_.cell_of_split[work_.split_of_hit[at / 3]]);
    at = work_.next_in_ring(at);
  } while (at != kNone && at != start);
}

// What a removal has changed may let others pass that did not before.
void SplitRemover::push_neighbours(CellId cell) {
  stale_.clear();
  if (work_.parent[cell] != kNone) stale_.push_back(work_.parent[cell]);
  for (const JoinedPiece& piece : removal_.pieces()) push_owners(piece.ring[0]);
  for (const RemovedRow& row : removal_.rows()) {
    for (const HalfEdgeId end : row.ends) {
      if (end == kNone) continue;
      push_owners(work_.loop[end] == row.beyond ? end : work_.next(end));
    }
  }
  make_set(stale_);
  for (const CellId c : stale_) {
    if (work_.is_minimal(c)) push(c);
  }
}

}  // namespace kdm
