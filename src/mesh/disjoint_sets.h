// SPDX-License-Identifier: MIT
// Sets that only ever grow together (union-find).
#pragma once

#include <numeric>
#include <utility>
#include <vector>

#include "kdmanifold/types.h"

namespace kdm {

/// The numbers below `size`, each in a set of its own at first.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t size) : parent_(size), count_(static_cast<Index>(size)) {
    std::iota(parent_.begin(), parent_.end(), Index{0});
  }

  /// The lowest number of the set that i is in.
  Index find(Index i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  /// Rem's algorithm: of the two parents the higher one's child moves on to the lower, on the way
  /// up to where they are the same.
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
  Index count() const { return count_; }

 private:
  std::vector<Index> parent_;
  Index count_;
};

}  // namespace kdm
