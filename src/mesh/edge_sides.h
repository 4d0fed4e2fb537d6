// SPDX-License-Identifier: MIT
// Gathers the sides of faces edge by edge.
#pragma once

#include <algorithm>
#include <numeric>
#include <span>
#include <vector>

#include "mesh/marks.h"
#include "mesh/numbers.h"
#include "mesh/sides.h"
#include "mesh/sort.h"

namespace kdm {

/// A side of a face, as it is listed among all the sides along the same edge. An edge joins a lower
/// and an upper point.
struct EdgeSide {
  PointId upper;  ///< the end of the edge with the higher number
  SideId side;    ///< the side's number
  bool forward;   ///< whether the side runs from the lower to the upper point
};

/// Sorts the sides of faces by the points of their edges. Sides that lead from a point to the same
/// point are left out. Takes linear time if no point has very many faces: the sides are put into
/// one bucket for each lower point, and then the buckets, which are short, are sorted.
class EdgeSides {
 public:
  /// Takes the sides of triangles, numbered as mesh/sides.h says. `points` is above all corner
  /// numbers.
  EdgeSides(std::span<const Triangle> triangles, Index points)
      : EdgeSides(points, [&](const auto& visit) {
          SideId side = 0;
          for (const Triangle& t : triangles) {
            for (int i = 0; i < 3; ++i, ++side) visit(t[i], t[next_corner(i)], side);
          }
        }) {}

  /// The same, but takes only the marked sides.
  EdgeSides(std::span<const Triangle> triangles, Index points, const Marks& taken)
      : EdgeSides(points, [&](const auto& visit) {
          for (SideId side = 0; side < taken.size(); ++side) {
            if (!taken.test(side)) continue;
            const Triangle& t = triangles[triangle_of(side)];
            visit(t[corner_of(side)], t[next_corner(corner_of(side))], side);
          }
        }) {}

  /// Takes the sides of any faces. `for_each(visit)` must call `visit(from, to, number)` for every
  /// side in order of the numbers; it is called twice.
  template <typename ForEach>
  EdgeSides(Index points, const ForEach& for_each)
      : bucket_begin_(static_cast<std::size_t>(points) + 1, 0) {
    for_each([first = bucket_begin_.data()](Index from, Index to, Index) {
      if (from != to) ++first[std::min(from, to) + 1];
    });
    std::partial_sum(bucket_begin_.begin(), bucket_begin_.end(), bucket_begin_.begin());
    sides_.resize(bucket_begin_.back());
    std::vector<Index> fill(bucket_begin_.begin(), bucket_begin_.end() - 1);
    for_each([sides = sides_.data(), next = fill.data()](Index from, Index to, Index side) {
      if (from != to) sides[next[std::min(from, to)]++] = {std::max(from, to), side, from < to};
    });
    // Sides come in order of their numbers and stay so.
    for (PointId p = 0; p < points; ++p) {
      sort_by(std::span(sides_).subspan(bucket_begin_[p], size(p)),
              [](const EdgeSide& a, const EdgeSide& b) { return a.upper < b.upper; });
    }
  }

  /// Calls `visit(lower, sides)` for each edge with its lower point and the sides along it, which
  /// ascend by number. Edges ascend by their lower, then by their upper point.
  template <typename Visit>
  void for_each_edge(const Visit& visit) const {
    for (Index p = 0; p + 1 < bucket_begin_.size(); ++p) {
      for (std::size_t first = bucket_begin_[p]; first != bucket_begin_[p + 1];) {
        std::size_t last = first + 1;
        while (last != bucket_begin_[p + 1] && sides_[last].upper == sides_[first].upper) ++last;
        visit(p, std::span<const EdgeSide>(&sides_[first], last - first));
        first = last;
      }
    }
  }

 private:
  std::size_t size(Index point) const { return bucket_begin_[point + 1] - bucket_begin_[point]; }

  std::vector<Index> bucket_begin_;  // per lower point: its first place in sides_
  std::vector<EdgeSide> sides_;
};

}  // namespace kdm
