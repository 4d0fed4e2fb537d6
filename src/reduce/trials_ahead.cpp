// SPDX-License-Identifier: MIT
// A step changes the triangles at two vertices, and a trial looks at those at the corners of the
// triangles that it would change: so it is enough to mark the corners of what a step changes. What
// is near without being joined is told by boxes. WebAssembly without threads leaves this file out.
#include "reduce/trials_ahead.h"

#ifdef KDM_HAS_THREADS

#include <algorithm>

#include "threads/share_work.h"

namespace kdm {
namespace {

// How many trials are made at a time: fewer where more than one in `kOften` is in vain, more where
// less than one in `kSeldom` is, so that threads seldom wait for each other.
constexpr std::size_t kLeastAhead = 16;
constexpr std::size_t kMostAhead = 512;
constexpr std::size_t kOften = 8;
constexpr std::size_t kSeldom = 32;
constexpr std::size_t kTrialsPerTask = 2;

}  // namespace

TrialsAhead::TrialsAhead(Workpiece& piece, const EdgeErrors& errors, const KeptLines& lines,
                         int threads)
    : piece_(piece), ahead_(kMostAhead), size_(kLeastAhead), changed_(piece.positions.size(), 0) {
  tests_.reserve(static_cast<std::size_t>(threads));
  for (int i = 0; i < threads; ++i) tests_.emplace_back(piece, errors, lines);
}

TrialsAhead::Ahead* TrialsAhead::find(const Candidate& candidate) {
  while (next_ < count_ && is_later(candidate, ahead_[next_].candidate)) ++next_;
  if (next_ == count_) return nullptr;
  Ahead& made = ahead_[next_];
  if (made.candidate.edge != candidate.edge || made.candidate.version != candidate.version ||
      made.candidate.place != candidate.place) {
    return nullptr;
  }
  ++next_;
  return &made;
}

bool TrialsAhead::is_fresh(const Ahead& made) const {
  const auto is_changed = [&](VertexId v) { return changed_[v] == time_; };
  const CollapseTrial& trial = made.trial;
  if (trial.verdict == CollapseTrial::Verdict::kNever) {
    for (const SideId side : {made.candidate.edge, piece_.mesh.opposite(made.candidate.edge)}) {
      if (side == kNone) continue;
      for (const VertexId v : piece_.mesh.corners(triangle_of(side))) {
        if (is_changed(v)) return false;
      }
    }
    return true;
  }
  const CollapseRing& ring = trial.ring;
  if (is_changed(ring.kept) || is_changed(ring.removed)) return false;
  for (const RingTriangle& t : ring.triangles) {
    if (is_changed(t.from) || is_changed(t.to)) return false;
  }
  if (piece_.distance->near[ring.kept] != made.near_before) return false;
  return std::none_of(boxes_.begin(), boxes_.end(),
                      [&](const SmallBox& box) { return box.meets(made.box); });
}

void TrialsAhead::begin(const Candidate& candidate) {
  if (made_in_vain_ * kOften > count_) {
    size_ = std::max(size_ / 2, kLeastAhead);
  } else if (made_in_vain_ * kSeldom < count_) {
    size_ = std::min(size_ * 2, kMostAhead);
  }
  ++time_;
  boxes_.clear();
  count_ = 0;
  next_ = 0;
  made_in_vain_ = 0;
  add(candidate);
}

void TrialsAhead::add(const Candidate& candidate) { ahead_[count_++].candidate = candidate; }

void TrialsAhead::make() {
  if (piece_.guard) piece_.guard->catch_up();
  const std::size_t tasks = (count_ + kTrialsPerTask - 1) / kTrialsPerTask;
  share_work(tasks, static_cast<int>(tests_.size()), [&](std::size_t task, int worker) {
    CollapseTest& test = tests_[static_cast<std::size_t>(worker)];
    const std::size_t end = std::min(count_, (task + 1) * kTrialsPerTask);
    for (std::size_t i = task * kTrialsPerTask; i < end; ++i) make(ahead_[i], test);
  });
}

void TrialsAhead::make(Ahead& one, CollapseTest& test) const {
  const VertexId kept = piece_.mesh.start(one.candidate.edge);
  one.near_before = piece_.distance->near[kept];
  test.run(one.candidate.edge, one.candidate.place, one.trial);
  one.box = {};
  if (!one.trial.asked_guard) return;
  one.box.grow(one.trial.ring.point);
  for (const RingTriangle& t : one.trial.ring.triangles) {
    one.box.grow(t.from_point);
    one.box.grow(t.to_point);
  }
}

const CollapseTrial& TrialsAhead::in_turn(const Candidate& candidate) {
  tests_.front().run(candidate.edge, candidate.place, in_turn_);
  return in_turn_;
}

void TrialsAhead::stepping(const CollapseRing& ring) {
  SmallBox box;
  box.grow(ring.point);
  const auto note = [&](VertexId v) {
    changed_[v] = time_;
    box.grow(piece_.positions[v]);
  };
  note(ring.kept);
  note(ring.removed);
  for (const RingTriangle& t : ring.triangles) {
    note(t.from);
    note(t.to);
  }
  boxes_.push_back(box);
}

}  // namespace kdm

#endif
