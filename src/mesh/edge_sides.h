// SPDX-License-Identifier: MIT
// The sides of triangles gathered by edge.
#pragma once

#include <algorithm>
#include <numeric>
#include <span>
#include <vector>

#include "kdmanifold/types.h"

namespace kdm {

/// The corner after corner `i`.
constexpr int next_corner(int i) { return i == 2 ? 0 : i + 1; }

/// Side 3t+i of triangle t, from corner i to corner i+1.
struct EdgeSide {
  Index upper;  ///< corner with the higher number
  Index side;
  bool forward;  ///< runs from the lower to the upper corner
};

/// All sides of triangles, in order of their edges' corners. Sides from a corner to an equal corner
/// are left out. Linear time for meshes of bounded valence: sides are bucketed by their lower
/// corner, the short buckets sorted.
class EdgeSides {
 public:
  /// `points` bounds the corner numbers.
  EdgeSides(std::span<const Triangle> triangles, Index points)
      : bucket_(static_cast<std::size_t>(points) + 1, 0) {
    for_each_side(triangles, [&](Index lower, const EdgeSide&) { ++bucket_[lower + 1]; });
    std::partial_sum(bucket_.begin(), bucket_.end(), bucket_.begin());
    sides_.resize(bucket_.back());
    std::vector<Index> fill(bucket_.begin(), bucket_.end() - 1);
    for_each_side(triangles, [&](Index lower, const EdgeSide& s) { sides_[fill[lower]++] = s; });
    for (Index p = 0; p < points; ++p) {
      std::sort(sides_.begin() + bucket_[p], sides_.begin() + bucket_[p + 1],
                [](const EdgeSide& a, const EdgeSide& b) {
                  return a.upper != b.upper ? a.upper < b.upper : a.side < b.side;
                });
    }
  }

  /// Calls `visit(lower corner, sides)` for each edge, sides in order of their numbers.
  template <typename Visit>
  void for_each_edge(const Visit& visit) const {
    for (Index p = 0; p + 1 < bucket_.size(); ++p) {
      for (std::size_t first = bucket_[p]; first != bucket_[p + 1];) {
        std::size_t last = first;
        while (last != bucket_[p + 1] && sides_[last].upper == sides_[first].upper) ++last;
        visit(p, std::span<const EdgeSide>(&sides_[first], last - first));
        first = last;
      }
    }
  }

 private:
  template <typename Visit>
  static void for_each_side(std::span<const Triangle> triangles, const Visit& visit) {
    for (std::size_t t = 0; t < triangles.size(); ++t) {
      for (int i = 0; i < 3; ++i) {
        const Index from = triangles[t][i];
        const Index to = triangles[t][next_corner(i)];
        const auto side = static_cast<Index>(3 * t + i);
        if (from != to) visit(std::min(from, to), EdgeSide{std::max(from, to), side, from < to});
      }
    }
  }

  std::vector<Index> bucket_;
  std::vector<EdgeSide> sides_;
};

}  // namespace kdm
