// SPDX-License-Identifier: MIT
// What a merge makes of two solids: which points are inside, given the solids that they are in.
#pragma once

#include <array>

#include "kdmanifold/expression.h"

namespace kdm {

/// A state is 1 for a point in the first solid, plus 2 for one in the second.
class MergeFunction {
 public:
  /// Throws `kInvalidOption` if the expression names other operands than 0 and 1, or holds for
  /// points far away.
  explicit MergeFunction(const Expression& expression);

  bool inside(int state) const { return inside_[state]; }
  /// Tells whether it makes a difference in which of the solids marked by the bits of `open` a
  /// point is, given the state but for these.
  bool depends_on(int open, int state) const {
    for (int other = 0; other < 4; ++other) {
      if ((other & ~open) == (state & ~open) && inside_[other] != inside_[state]) return true;
    }
    return false;
  }

 private:
  std::array<bool, 4> inside_{};
};

}  // namespace kdm
