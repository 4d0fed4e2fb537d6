// SPDX-License-Identifier: MIT
// Lists the yes-or-no questions whose answers determine a sheet's links across one minimal face.
// Saving writes the answers, loading reads them.
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "kdmanifold/types.h"
#include "mesh/marks.h"

namespace kdm {

class SheetLinkDecisions {
 public:
  /// Asks the questions for one face and reports the links that follow from the answers.
  ///
  /// The hits round the face are numbered in cyclic order; `starts_below[i]` says where the
  /// half-edge of hit i starts. For each hit i that has no partner yet while later hits without
  /// partner run against it, it asks whether it has one, `linked(i)`. If so, it asks for these
  /// later hits j in turn, `partner(i, j)`, until the answer is yes; the last of them needs no
  /// question. Then it calls `link(i, j)`. Takes as many steps as there are hits and questions.
  template <typename Linked, typename Partner, typename Link>
  void operator()(const Marks& starts_below, Linked&& linked, Partner&& partner, Link&& link) {
    const auto count = static_cast<Index>(starts_below.size());
    for (Open& side : open_) side.clear();
    for (Index i = 0; i < count; ++i) open_[starts_below.test(i) ? 1 : 0].hits.push_back(i);
    for (Index i = 0; i < count; ++i) {
      Open& own = open_[starts_below.test(i) ? 1 : 0];
      if (own.empty() || own.hits[own.front] != i) continue;
      ++own.front;
      Open& others = open_[starts_below.test(i) ? 0 : 1];
      if (others.empty() || !linked(i)) continue;
      std::size_t at = others.front;
      while (at + 1 < others.hits.size() && !partner(i, others.hits[at])) ++at;
      link(i, others.hits[at]);
      others.take(at);
    }
  }

 private:
  // The hits of one direction; those from `front` on have no partner yet.
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
  std::array<Open, 2> open_;  // by starts_below
};

}  // namespace kdm
