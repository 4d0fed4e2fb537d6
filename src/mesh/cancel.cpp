// SPDX-License-Identifier: MIT
// Triangles are bucketed by their lowest corner and compared within the short buckets.
#include "mesh/cancel.h"

#include <algorithm>
#include <numeric>

namespace kdm {
namespace {

// Corners from the lowest on, turned so that the second is lower than the third.
struct Key {
  Index second;
  Index third;
  bool turned;
  Index triangle;
};

}  // namespace

std::vector<char> find_opposite_pairs(std::span<const Triangle> triangles, Index points) {
  const auto lowest = [](const Triangle& t) {
    return static_cast<int>(std::min_element(t.begin(), t.end()) - t.begin());
  };
  std::vector<Index> bucket(static_cast<std::size_t>(points) + 1, 0);
  for (const Triangle& t : triangles) ++bucket[t[lowest(t)] + 1];
  std::partial_sum(bucket.begin(), bucket.end(), bucket.begin());
  std::vector<Key> keys(triangles.size());
  std::vector<Index> fill(bucket.begin(), bucket.end() - 1);
  for (Index i = 0; i < triangles.size(); ++i) {
    const Triangle& t = triangles[i];
    const int k = lowest(t);
    const Index b = t[(k + 1) % 3];
    const Index c = t[(k + 2) % 3];
    keys[fill[t[k]]++] = {std::min(b, c), std::max(b, c), b > c, i};
  }
  std::vector<char> cancelled(triangles.size(), 0);
  for (Index p = 0; p < points; ++p) {
    const auto end = keys.begin() + bucket[p + 1];
    std::sort(keys.begin() + bucket[p], end, [](const Key& a, const Key& b) {
      return std::array{a.second, a.third, a.triangle} < std::array{b.second, b.third, b.triangle};
    });
    for (auto first = keys.begin() + bucket[p]; first != end;) {
      auto last = first;
      while (last != end && last->second == first->second && last->third == first->third) ++last;
      // Each triangle takes the first one left that faces the other way.
      for (auto a = first; a != last; ++a) {
        for (auto b = a + 1; b != last && cancelled[a->triangle] == 0; ++b) {
          if (cancelled[b->triangle] != 0 || a->turned == b->turned) continue;
          cancelled[a->triangle] = cancelled[b->triangle] = 1;
        }
      }
      first = last;
    }
  }
  return cancelled;
}

}  // namespace kdm
