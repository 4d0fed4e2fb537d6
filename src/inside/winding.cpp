// SPDX-License-Identifier: MIT
// Follows the winding number up one edge.
#include "inside/winding.h"

#include "mesh/sort.h"

namespace kdm {
void sort_crossings(std::span<Crossing> crossings) {
  sort_by(crossings, [](const Crossing& a, const Crossing& b) {
    return a.position != b.position ? a.position < b.position : a.triangle < b.triangle;
  });
}

int classify_crossings(std::vector<Crossing>& found, int winding_below, InsideRule rule,
                       std::vector<ClassifiedCrossing>& classified) {
  sort_crossings(found);
  int winding = winding_below;
  for (std::size_t first = 0; first < found.size();) {
    std::size_t last = first;
    int after = winding;
    while (last < found.size() && found[last].position == found[first].position) {
      after = state_after(after, found[last]);
      ++last;
    }
    const bool was_inside = is_inside(rule, winding);
    const bool changes = was_inside != is_inside(rule, after);
    const CrossingRole others = last - first > 1 && !was_inside && !changes
                                    ? CrossingRole::kTouching
                                    : CrossingRole::kInner;
    std::size_t keep = first;
    while (keep < last && found[keep].leaving != was_inside) ++keep;
    if (keep == last) keep = first;
    for (std::size_t i = first; i < last; ++i) {
      classified.emplace_back(found[i].position, found[i].triangle, after,
                              changes && i == keep ? CrossingRole::kBounds : others, was_inside);
    }
    winding = after;
    first = last;
  }
  return winding;
}

}  // namespace kdm
