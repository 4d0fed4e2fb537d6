// SPDX-License-Identifier: MIT
// Follows the winding number along a grid edge and finds which of the edge's crossings bound the
// solid (paper 5.2).
#pragma once

#include <span>
#include <vector>

#include "inside/crossing.h"
#include "kdmanifold/build.h"

namespace kdm {

/// Returns whether points with this winding number are in the solid.
constexpr bool is_inside(InsideRule rule, int winding) {
  switch (rule) {
    case InsideRule::kPositive:
    case InsideRule::kRepair:
      return winding > 0;
    case InsideRule::kOdd:
      return winding % 2 != 0;
    case InsideRule::kNonzero:
      return winding != 0;
    case InsideRule::kSheet:
      return false;  // there is no solid
  }
  return false;
}

/// Returns the winding number above a crossing below which it is `winding`.
inline int state_after(int winding, const Crossing& crossing) {
  return winding + (crossing.leaving ? -1 : 1);
}

/// Sorts crossings by ascending position along the edge; crossings at the same position are sorted
/// by the number of their triangle.
void sort_crossings(std::span<Crossing> crossings);

/// Sorts the crossings found on one edge, follows the winding number up the edge from
/// `winding_below`, and appends each crossing to `classified`. Where points below and above a
/// crossing differ in whether they are inside, the crossing is kept. Crossings at the same position
/// are taken together, so that no inside or outside stretch has length zero: if points below and
/// above them differ, one of them is kept, namely the first that leaves or enters the solid as the
/// change demands or, if there is none, the first of all. Returns the winding number at the upper
/// end.
int classify_crossings(std::vector<Crossing>& found, int winding_below, InsideRule rule,
                       std::vector<ClassifiedCrossing>& classified);

}  // namespace kdm
