// SPDX-License-Identifier: MIT
// Winding numbers along a grid edge, and which of its crossings bound the solid (paper 5.2).
#pragma once

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

/// Sorts crossings up the edge; those at one position by the number of their triangle.
void sort_crossings(std::vector<Crossing>& crossings);

/// Sorts the crossings found on one edge, follows the winding number up the edge from
/// `winding_below`, and appends each crossing to `classified`. Where the inside rule changes, one
/// crossing is kept. Crossings at one position count together, so that no stretch of length zero
/// survives; of these the first that runs the way of the change is kept, or the first of all if
/// none does. Returns the winding number at the upper end.
int classify_crossings(std::vector<Crossing>& found, int winding_below, InsideRule rule,
                       std::vector<ClassifiedCrossing>& classified);

}  // namespace kdm
