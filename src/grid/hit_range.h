// SPDX-License-Identifier: MIT
// Consecutive hits of one splitting edge.
#pragma once

#include "mesh/numbers.h"

namespace kdm {

/// The numbers from `first` up to `beyond`, which is not one of them. A `for` loop over a range
/// yields numbers of hits in ascending order, which is also their order along the edge.
struct HitRange {
  HitId first = 0;
  HitId beyond = 0;

  class Iterator {
   public:
    explicit Iterator(HitId hit) : hit_(hit) {}
    HitId operator*() const { return hit_; }
    Iterator& operator++() {
      ++hit_;
      return *this;
    }
    bool operator==(const Iterator&) const = default;

   private:
    HitId hit_;
  };

  Iterator begin() const { return Iterator(first); }
  Iterator end() const { return Iterator(beyond); }
  Index size() const { return beyond - first; }
  bool empty() const { return first == beyond; }
};

}  // namespace kdm
