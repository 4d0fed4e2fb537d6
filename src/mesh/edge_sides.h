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
    for_each_side(triangles, [sides = sides_.data(), next = fill.data()](
                                 Index lower, const EdgeSide& s) { sides[next[lower]++] = s; });
    for (Index p = 0; p < points; ++p) sort(std::span(sides_).subspan(bucket_[p], size(p)));
  }

  /// Calls `visit(lower corner, sides)` for each edge, sides in order of their numbers.
  template <typename Visit>
  void for_each_edge(const Visit& visit) const {
    for (Index p = 0; p + 1 < bucket_.size(); ++p) {
      for (std::size_t first = bucket_[p]; first != bucket_[p + 1];) {
        std::size_t last = first + 1;
        while (last != bucket_[p + 1] && sides_[last].upper == sides_[first].upper) ++last;
        visit(p, std::span<const EdgeSide>(&sides_[first], last - first));
        first = last;
      }
    }
  }

 private:
  std::size_t size(Index point) const { return bucket_[point + 1] - bucket_[point]; }

  // By the upper corner; sides come in order of their numbers and stay so.
  static void sort(std::span<EdgeSide> bucket) {
    constexpr std::size_t kShort = 32;
    if (bucket.size() > kShort) {
      std::sort(bucket.begin(), bucket.end(), [](const EdgeSide& a, const EdgeSide& b) {
        return a.upper != b.upper ? a.upper < b.upper : a.side < b.side;
      });
      return;
    }
    for (std::size_t i = 1; i < bucket.size(); ++i) {
      const EdgeSide inserted = bucket[i];
      std::size_t place = i;
      for (; place > 0 && bucket[place - 1].upper > inserted.upper; --place) {
        bucket[place] = bucket[place - 1];
      }
      bucket[place] = inserted;
    }
  }

  template <typename Visit>
  static void for_each_side(std::span<const Triangle> triangles, const Visit& visit) {
    Index side = 0;
    for (const Triangle& t : triangles) {
      for (int i = 0; i < 3; ++i, ++side) {
        const Index from = t[i];
        const Index to = t[next_corner(i)];
        if (from != to) visit(std::min(from, to), EdgeSide{std::max(from, to), side, from < to});
      }
    }
  }

  std::vector<Index> bucket_;
  std::vector<EdgeSide> sides_;
};

}  // namespace kdm
