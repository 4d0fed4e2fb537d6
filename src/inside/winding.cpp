// SPDX-License-Identifier: MIT
// The walk along one edge.
#include "inside/winding.h"

#include <algorithm>

namespace kdm {

void sort_crossings(std::vector<Crossing>& crossings) {
  if (crossings.size() < 2) return;
  std::sort(crossings.begin(), crossings.end(), [](const Crossing& a, const Crossing& b) {
    return a.position != b.position ? a.position < b.position : a.triangle < b.triangle;
  });
}

int walk_edge(std::vector<Crossing>& crossings, int winding_below, InsideRule rule,
              std::vector<WalkedCrossing>& walked) {
  walked.clear();
  sort_crossings(crossings);
  if (rule == InsideRule::kSheet) {
    for (const Crossing& crossing : crossings) {
      walked.push_back({crossing, winding_below, true, crossing.leaving});
    }
    return winding_below;
  }
  int winding = winding_below;
  for (std::size_t first = 0; first < crossings.size();) {
    std::size_t last = first;
    int after = winding;
    while (last < crossings.size() && crossings[last].position == crossings[first].position) {
      after += crossings[last].leaving ? -1 : 1;
      ++last;
    }
    const bool was_inside = is_inside(rule, winding);
    const bool changes = was_inside != is_inside(rule, after);
    // The one to keep: the first that runs the way of the change; else (odd rule) the first.
    std::size_t keep = first;
    while (keep < last && crossings[keep].leaving != was_inside) ++keep;
    if (keep == last) keep = first;
    for (std::size_t i = first; i < last; ++i) {
      walked.push_back({crossings[i], after, changes && i == keep, was_inside});
    }
    winding = after;
    first = last;
  }
  return winding;
}

}  // namespace kdm
