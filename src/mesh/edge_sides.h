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

/// Side 3t+i of triangle t is that from corner i to corner i+1.
struct EdgeSide {
  Index upper;  ///< corner with the higher number
  Index side;
  bool forward;  ///< runs from the lower to the upper corner
};

/// All sides of faces, in order of their edges' corners. Sides from a corner to an equal corner
/// are left out. Linear time for meshes of bounded valence: sides are bucketed by their lower
/// corner, the short buckets sorted.
class EdgeSides {
 public:
  /// `points` bounds the corner numbers.
  EdgeSides(std::span<const Triangle> triangles, Index points)
      : EdgeSides(points, [&](const auto& visit) {
          Index side = 0;
          for (const Triangle& t : triangles) {
            for (int i = 0; i < 3; ++i, ++side) visit(t[i], t[next_corner(i)], side);
          }
        }) {}

  /// `for_each` calls what it is given with every side's corners, from and to, and its number, in
  /// order of the numbers. It is run twice.
  template <typename ForEach>
  EdgeSides(Index points, const ForEach& for_each)
      : bucket_(static_cast<std::size_t>(points) + 1, 0) {
    for_each([first = bucket_.data()](Index from, Index to, Index) {
      if (from != to) ++first[std::min(from, to) + 1];
    });
    std::partial_sum(bucket_.begin(), bucket_.end(), bucket_.begin());
    sides_.resize(bucket_.back());
    std::vector<Index> fill(bucket_.begin(), bucket_.end() - 1);
    for_each([sides = sides_.data(), next = fill.data()](Index from, Index to, Index side) {
      if (from != to) sides[next[std::min(from, to)]++] = {std::max(from, to), side, from < to};
    });
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

  std::vector<Index> bucket_;
  std::vector<EdgeSide> sides_;
};

}  // namespace kdm
