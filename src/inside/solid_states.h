// SPDX-License-Identifier: MIT
// Numbers the combinations of winding numbers that occur where several solids have one each.
#pragma once

#include <vector>

#include "inside/solid_function.h"
#include "kdmanifold/build.h"

namespace kdm {

/// The states of points: each stands for one winding number a solid. State 0 is that of points far
/// away, which have none but zeros. How the others are numbered depends on the order in which they
/// are met, so nothing may follow from a number itself.
class SolidStates {
 public:
  /// `rules` says for each solid which winding numbers are inside.
  SolidStates(SolidFunction function, std::vector<InsideRule> rules);

  /// Tells whether points of the state lie in the result.
  bool is_inside(int state) const { return inside_.test(static_cast<std::size_t>(state)); }
  /// Returns the state beyond a triangle of a solid: winding number one higher, or one lower.
  int after(int state, Index solid, bool leaving) {
    const std::size_t way = (static_cast<std::size_t>(state) * solids() + solid) * 2 + leaving;
    return next_[way] >= 0 ? next_[way] : find(state, solid, leaving);
  }
  /// Unmarks the solids of which it makes no difference what their winding numbers are; the solids
  /// without mark have those of the state.
  void keep_relevant(int state, Marks& solids);

  std::size_t solids() const { return rules_.size(); }

 private:
  int find(int state, Index solid, bool leaving);
  void add(const std::vector<int>& windings);
  void mark_solids(const int* windings);

  SolidFunction function_;
  std::vector<InsideRule> rules_;
  std::vector<int> windings_;  // per state, one a solid
  std::vector<int> next_;  // per state and solid: after entering and after leaving it; -1: unknown
  std::vector<int> in_order_;  // the states, ascending by their windings
  Marks inside_;               // per state
  Marks in_solids_;            // scratch
};

}  // namespace kdm
