// SPDX-License-Identifier: MIT
// Dynamic programme over intervals: the first point of an interval is paired with every point it
// may be paired with, which leaves two independent intervals.
#include "build/matching.h"

#include <limits>

#include "geometry/assert.h"

namespace kdm {

std::vector<Index> match_without_crossings(Index count,
                                           const std::function<double(Index, Index)>& cost) {
  KDM_ASSERT(count % 2 == 0, "an even number of hits lies round a minimal face");
  // best[i][n]: least cost of pairing the n points from i on; choice: partner of i in it.
  const std::size_t row = count + 1;
  std::vector<double> best((count + 1) * row, 0.0);
  std::vector<Index> choice((count + 1) * row, kNone);
  for (Index length = 2; length <= count; length += 2) {
    for (Index i = 0; i + length <= count; ++i) {
      double least = std::numeric_limits<double>::infinity();
      for (Index n = 2; n <= length; n += 2) {
        const Index j = i + n - 1;
        const double total =
            cost(i, j) + best[(i + 1) * row + n - 2] + best[(j + 1) * row + length - n];
        if (total < least || n == 2) {
          least = total;
          choice[i * row + length] = j;
        }
      }
      best[i * row + length] = least;
    }
  }
  std::vector<Index> partner(count, kNone);
  std::vector<std::pair<Index, Index>> open{{0, count}};  // first point and number of points
  while (!open.empty()) {
    const auto [i, length] = open.back();
    open.pop_back();
    if (length == 0) continue;
    const Index j = choice[i * row + length];
    partner[i] = j;
    partner[j] = i;
    open.emplace_back(i + 1, j - i - 1);
    open.emplace_back(j + 1, length - (j - i + 1));
  }
  return partner;
}

std::vector<Index> match_brackets(const std::vector<bool>& opens) {
  const auto count = static_cast<Index>(opens.size());
  // Read from the point of least depth on, no bracket closes before it has opened.
  Index first = 0;
  int depth = 0;
  int least = 0;
  for (Index i = 0; i < count; ++i) {
    depth += opens[i] ? 1 : -1;
    if (depth < least) {
      least = depth;
      first = i + 1;
    }
  }
  KDM_ASSERT(depth == 0, "as many hits lead one way across a minimal face as the other");
  std::vector<Index> partner(count, kNone);
  std::vector<Index> open;
  for (Index n = 0; n < count; ++n) {
    const Index i = (first + n) % count;
    if (opens[i]) {
      open.push_back(i);
      continue;
    }
    partner[i] = open.back();
    partner[open.back()] = i;
    open.pop_back();
  }
  return partner;
}

}  // namespace kdm
