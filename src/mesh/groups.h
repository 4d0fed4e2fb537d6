// SPDX-License-Identifier: MIT
// Sorts numbers into groups.
#pragma once

#include <numeric>
#include <span>
#include <vector>

#include "kdmanifold/types.h"

namespace kdm {

/// Holds items, each a number, sorted by the group that each was put into. Within a group, items
/// keep the order in which they were put. Takes linear time (a counting sort).
class Groups {
 public:
  Groups() = default;
  /// `for_each(put)` must call `put(group, item)` for every item; it is called twice. Groups are
  /// numbered below `groups`.
  template <typename ForEach>
  Groups(std::size_t groups, const ForEach& for_each) : begin_(groups + 1, 0) {
    for_each([&](Index group, Index) { ++begin_[group + 1]; });
    std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
    items_.resize(begin_.back());
    std::vector<Index> next(begin_.begin(), begin_.end() - 1);
    for_each([&](Index group, Index item) { items_[next[group]++] = item; });
  }

  /// Returns the items of a group.
  std::span<const Index> of(Index group) const {
    return {items_.data() + begin_[group], begin_[group + 1] - begin_[group]};
  }
  /// Returns how many items there are in the groups before this one.
  Index items_before(Index group) const { return begin_[group]; }
  /// Returns all items, group after group.
  std::span<const Index> items() const { return items_; }

 private:
  std::vector<Index> begin_;  // per group: its first place in items_
  std::vector<Index> items_;
};

}  // namespace kdm
