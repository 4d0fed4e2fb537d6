// SPDX-License-Identifier: MIT
// Finds triangles over the same three points.
#pragma once

#include <algorithm>
#include <array>
#include <numeric>
#include <span>
#include <vector>

#include "mesh/numbers.h"
#include "mesh/sort.h"

namespace kdm {

/// A triangle with its points in ascending order. The lowest one is not kept: it is the same for
/// all triangles of a group.
struct SortedCorners {
  PointId second;
  PointId third;
  bool turned;  ///< the triangle runs through its points in descending order
  TriangleId triangle;
};

/// Calls `visit(group)` for each set of three points with the triangles over it, ascending by their
/// numbers. `points` is above all corner numbers. Takes linear time if no point has very many
/// triangles: the triangles are put into one bucket for each lowest point, and then the buckets,
/// which are short, are sorted.
template <typename Visit>
void for_each_corner_set(std::span<const Triangle> triangles, Index points, const Visit& visit) {
  const auto lowest = [](const Triangle& t) {
    return static_cast<int>(std::min_element(t.begin(), t.end()) - t.begin());
  };
  std::vector<Index> bucket(static_cast<std::size_t>(points) + 1, 0);
  for (const Triangle& t : triangles) ++bucket[t[lowest(t)] + 1];
  std::partial_sum(bucket.begin(), bucket.end(), bucket.begin());
  std::vector<SortedCorners> keys(triangles.size());
  std::vector<Index> fill(bucket.begin(), bucket.end() - 1);
  for (TriangleId i = 0; i < triangles.size(); ++i) {
    const Triangle& t = triangles[i];
    const int k = lowest(t);
    const PointId b = t[(k + 1) % 3];
    const PointId c = t[(k + 2) % 3];
    keys[fill[t[k]]++] = {std::min(b, c), std::max(b, c), b > c, i};
  }
  for (PointId p = 0; p < points; ++p) {
    const auto group = std::span(keys).subspan(bucket[p], bucket[p + 1] - bucket[p]);
    sort_by(group, [](const SortedCorners& a, const SortedCorners& b) {
      return std::array{a.second, a.third, a.triangle} < std::array{b.second, b.third, b.triangle};
    });
    const auto end = keys.begin() + bucket[p + 1];
    for (auto first = keys.begin() + bucket[p]; first != end;) {
      auto last = first;
      while (last != end && last->second == first->second && last->third == first->third) ++last;
      visit(std::span<const SortedCorners>(&*first, static_cast<std::size_t>(last - first)));
      first = last;
    }
  }
}

}  // namespace kdm
