// SPDX-License-Identifier: MIT
// Disjoint sets of numbers that can be joined (union-find).
#pragma once

#include <numeric>
#include <utility>
#include <vector>

#include "kdmanifold/types.h"

namespace kdm {

/// Divides the numbers below `size` into sets: at first each is in a set of its own, then sets are
/// joined. Each operation takes nearly constant time on average.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t size) : parent_(size), count_(static_cast<Index>(size)) {
    std::iota(parent_.begin(), parent_.end(), Index{0});
  }

  /// Returns the lowest number of the set that i is in.
  Index find(Index i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  /// Joins the sets that i and j are in. This is Rem's algorithm: it climbs from both numbers
  /// towards their roots, and on the way hangs the one with the higher parent below the lower
  /// parent.
  void join(Index i, Index j) {
    while (parent_[i] != parent_[j]) {
      if (parent_[i] < parent_[j]) std::swap(i, j);
      const Index up = parent_[i];
      parent_[i] = parent_[j];
      if (up == i) {
        --count_;
        return;
      }
      i = up;
    }
  }
  /// Returns how many sets there are.
  Index count() const { return count_; }

 private:
  std::vector<Index> parent_;
  Index count_;
};

}  // namespace kdm
