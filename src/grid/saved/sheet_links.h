// SPDX-License-Identifier: MIT
// What has to be told of a sheet's links across one minimal face; saving and loading share it.
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "kdmanifold/types.h"

namespace kdm {

class SheetLinkDecisions {
 public:
  /// Goes through the hits round a face, of which some start below it. Of each hit that has no
  /// partner yet, though later ones without partner run against it, asks `linked(i)`; if so, of
  /// these in turn `partner(i, j)` until it is so, the last without asking; then calls
  /// `link(i, j)`. Takes as many steps as there are hits and questions.
  template <typename Linked, typename Partner, typename Link>
  void operator()(const std::vector<bool>& starts_below, Linked&& linked, Partner&& partner,
                  Link&& link) {
    const auto count = static_cast<Index>(starts_below.size());
    for (Open& side : open_) side.clear();
    for (Index i = 0; i < count; ++i) open_[starts_below[i] ? 1 : 0].hits.push_back(i);
    for (Index i = 0; i < count; ++i) {
      Open& own = open_[starts_below[i] ? 1 : 0];
      if (own.empty() || own.hits[own.front] != i) continue;
      ++own.front;
      Open& others = open_[starts_below[i] ? 0 : 1];
      if (others.empty() || !linked(i)) continue;
      std::size_t at = others.front;
      while (at + 1 < others.hits.size() && !partner(i, others.hits[at])) ++at;
      link(i, others.hits[at]);
      others.take(at);
    }
  }

 private:
  // The hits of one direction that have no partner, from `front` on.
  struct Open {
    std::vector<Index> hits;
    std::size_t front = 0;

    bool empty() const { return front == hits.size(); }
    void clear() {
      hits.clear();
      front = 0;
    }
    void take(std::size_t at) {
      const auto begin = hits.begin();
      const auto taken = begin + static_cast<std::ptrdiff_t>(at);
      std::move_backward(begin + static_cast<std::ptrdiff_t>(front), taken, taken + 1);
      ++front;
    }
  };
  std::array<Open, 2> open_;
};

}  // namespace kdm
