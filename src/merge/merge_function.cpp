// SPDX-License-Identifier: MIT
#include "merge/merge_function.h"

#include "inside/solid_function.h"
#include "kdmanifold/error.h"
#include "text/compose.h"

namespace kdm {

MergeFunction::MergeFunction(const Expression& expression) {
  if (expression.operands() > 2) {
    throw Error(ErrorCode::kInvalidOption,
                compose("expression: it names operand {}, but a merge has two grids, 0 and 1",
                        expression.operands() - 1));
  }
  SolidFunction function(expression, std::array<Index, 2>{0, 1});
  for (int state = 0; state < 4; ++state) {
    Marks inside(2);
    inside.set(0, (state & 1) != 0);
    inside.set(1, (state & 2) != 0);
    inside_[state] = function.value(inside);
  }
  if (inside_[0]) {
    throw Error(ErrorCode::kInvalidOption,
                "expression: it holds for points far away from both grids");
  }
}

}  // namespace kdm
