// SPDX-License-Identifier: MIT
// Numbers in groups.
#pragma once

#include <numeric>
#include <span>
#include <vector>

#include "kdmanifold/types.h"

namespace kdm {

/// Groups by number, each with what was put into it, in that order: a counting sort.
class Groups {
 public:
  Groups() = default;
  /// `for_each` calls what it is given with every item's group and the item, and is run twice.
  template <typename ForEach>
  Groups(std::size_t groups, const ForEach& for_each) : begin_(groups + 1, 0) {
    for_each([&](Index group, Index) { ++begin_[group + 1]; });
    std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
    items_.resize(begin_.back());
    std::vector<Index> next(begin_.begin(), begin_.end() - 1);
    for_each([&](Index group, Index item) { items_[next[group]++] = item; });
  }

  std::span<const Index> of(Index group) const {
    return {items_.data() + begin_[group], begin_[group + 1] - begin_[group]};
  }

 private:
  std::vector<Index> begin_;
  std::vector<Index> items_;
};

}  // namespace kdm
