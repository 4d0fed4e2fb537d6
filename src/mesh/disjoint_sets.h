// SPDX-License-Identifier: MIT
// Sets that only ever grow together (union-find with path halving).
#pragma once

#include <algorithm>
#include <numeric>
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
  void join(Index i, Index j) {
    i = find(i);
    j = find(j);
    if (i == j) return;
    parent_[std::max(i, j)] = std::min(i, j);
    --count_;
  }
  Index count() const { return count_; }

 private:
  std::vector<Index> parent_;
  Index count_;
};

}  // namespace kdm
