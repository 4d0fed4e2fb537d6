// SPDX-License-Identifier: MIT
// Which of an edge's crossings bound the solid (algorithm: winding numbers and inside rules).
#pragma once

#include <vector>

#include "geometry/predicates.h"
#include "kdmanifold/build.h"

namespace kdm {

/// An intersection of the input with a grid edge, before the inside rule has filtered it.
struct Crossing {
  LinePosition position;
  Index triangle;
  bool leaving;  ///< the triangle's normal points up the edge
};

/// Is a point of this winding number in the solid?
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

/// A crossing with what the walk along the edge found.
struct WalkedCrossing {
  Crossing crossing;
  int winding_after;  ///< just above it
  bool kept;          ///< the inside rule changes here ...
  bool leaving;       ///< ... from inside to outside
};

/// Up the edge; at one position by number.
void sort_crossings(std::vector<Crossing>& crossings);

/// Sorts the crossings of one edge and walks up it from a point of known winding. Crossings at
/// one position count together, so that no stretch of length zero survives; of these the first
/// whose own direction fits is kept. Returns the winding number at the upper end. Sheets keep every
/// crossing as it runs and have no winding numbers: theirs stays what it was.
int walk_edge(std::vector<Crossing>& crossings, int winding_below, InsideRule rule,
              std::vector<WalkedCrossing>& walked);

}  // namespace kdm
