// SPDX-License-Identifier: MIT
// Trials of edges that several threads make before it is their turn.
#pragma once

#include <cstddef>
#include <vector>

#include "mesh/small_box.h"
#include "reduce/collapse_queue.h"
#include "reduce/collapse_test.h"
#include "threads/has_threads.h"

#ifdef KDM_HAS_THREADS

namespace kdm {

/// Makes the trials of the next few candidates of a queue at a time, on the mesh as it is. When it
/// is a candidate's turn, its trial counts unless a step has changed something that it looked at;
/// then it is made again. So trials say what they would have said in turn.
class TrialsAhead {
 public:
  /// All must outlive this. The piece must keep a distance: without, trials take less time than
  /// sharing them.
  TrialsAhead(Workpiece& piece, const EdgeErrors& errors, const KeptLines& lines, int threads);

  /// Returns the trial of a candidate that was taken from the queue. `is_current` tells of those
  /// that are still in it whether they count.
  template <typename IsCurrent>
  const CollapseTrial& of(const Candidate& candidate, CollapseQueue& queue,
                          const IsCurrent& is_current) {
    if (Ahead* made = find(candidate)) {
      if (is_fresh(*made)) return made->trial;
      ++made_in_vain_;
    } else if (next_ == count_) {
      begin(candidate);
      queue.look_ahead(size_ - 1, is_current, [&](const Candidate& later) { add(later); });
      make();
      return ahead_[next_++].trial;
    }
    return in_turn(candidate);
  }

  /// Makes known that a step is about to be taken.
  void stepping(const CollapseRing& ring);

 private:
  // A candidate and its trial.
  struct Ahead {
    Candidate candidate;
    CollapseTrial trial;
    TriangleId near_before;  // the reference's triangle known near the vertex that would be kept
    SmallBox box;            // round the triangles that were held against the rest of the mesh
  };

  Ahead* find(const Candidate& candidate);
  bool is_fresh(const Ahead& made) const;
  void begin(const Candidate& candidate);
  void add(const Candidate& candidate);
  void make();
  void make(Ahead& one, CollapseTest& test) const;
  const CollapseTrial& in_turn(const Candidate& candidate);

  Workpiece& piece_;
  std::vector<CollapseTest> tests_;  // per worker
  std::vector<Ahead> ahead_;         // in the order of the queue; kept for their memory
  std::size_t count_ = 0;            // how many of them are made
  std::size_t next_ = 0;             // the first one whose turn has not come yet
  std::size_t size_;                 // how many are made at a time
  std::size_t made_in_vain_ = 0;     // of those made last
  std::vector<Index> changed_;       // per vertex: when its triangles were last changed
  std::vector<SmallBox> boxes_;      // round what has been changed since the trials were made
  Index time_ = 0;                   // counts how often trials were made
  CollapseTrial in_turn_;
};

}  // namespace kdm

#endif
