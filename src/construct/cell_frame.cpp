// SPDX-License-Identifier: MIT
#include "construct/cell_frame.h"

namespace kdm {

void divide_box(const CellFrame& frame, const Split& split, CellId first_child, Halves& halves) {
  halves.below.cell = first_child;
  halves.above.cell = first_child + 1;
  halves.below.depth = halves.above.depth = frame.depth + 1;
  halves.below.box.hi[split.axis] = split.value;
  halves.above.box.lo[split.axis] = split.value;
}

void divide_progress(const CellFrame& frame, Halves& halves) {
  const double below = halves.below.triangles.size();
  const double both = below + halves.above.triangles.size();
  halves.below.done_after = halves.above.done_before =
      frame.done_before + (frame.done_after - frame.done_before) * (both > 0 ? below / both : 0.5);
}

}  // namespace kdm
