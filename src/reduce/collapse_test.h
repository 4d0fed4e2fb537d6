// SPDX-License-Identifier: MIT
// Whether an edge may be collapsed: the result must stay manifold, meet itself nowhere and stay
// near to the reference.
#pragma once

#include <optional>
#include <vector>

#include "reduce/edge_errors.h"
#include "reduce/kept_lines.h"
#include "reduce/near_test.h"
#include "reduce/ring.h"
#include "reduce/smooth_test.h"
#include "reduce/workpiece.h"

namespace kdm {

/// What a test of an edge found out.
struct CollapseTrial {
  enum class Verdict {
    kFits,     ///< the edge may be collapsed
    kNoPlace,  ///< not to this place
    kNever,    ///< nowhere, as long as its surroundings stay what they are
    kBeyond    ///< it would change what the piece must leave as it is: nothing is known
  };

  Verdict verdict = Verdict::kNever;
  CollapseRing ring;   ///< what there would be; without meaning if it is `kNever` or `kBeyond`
  NearFind near;       ///< if a distance is kept and the tests came to it
  KeptLines::Cut cut;  ///< if the edge may be collapsed and is on a border
};

/// The tests, in order of what they cost.
class CollapseTest {
 public:
  /// All must outlive this.
  CollapseTest(Workpiece& piece, const EdgeErrors& errors, const KeptLines& lines);

  /// Tries what collapsing the edge would leave.
  void run(SideId edge, CollapsePlace place, CollapseTrial& trial);

 private:
  bool meets_link_condition(SideId edge);
  void make_ring(SideId edge, const Vec3& point, CollapseRing& ring) const;
  bool fits(SideId edge, CollapseTrial& trial);
  bool keeps_shape(const CollapseRing& ring) const;
  bool is_guarded(const CollapseRing& ring);

  Workpiece& piece_;
  const EdgeErrors& errors_;
  const KeptLines& lines_;
  std::optional<SmoothTest> smooth_;                // if a distance is kept
  std::optional<CrossingGuard::Scratch> crossing_;  // if there is a guard
  std::vector<Index> seen_;                         // per vertex: the last stamp it got
  Index stamp_ = 0;
};

}  // namespace kdm
