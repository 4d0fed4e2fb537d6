// SPDX-License-Identifier: MIT
// Which edge is collapsed next.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "mesh/numbers.h"

namespace kdm {

/// Where the vertex goes that an edge becomes.
enum class CollapsePlace : std::uint8_t {
  kBest,   ///< where the error is least
  kStart,  ///< to the start of the edge's half-edge
  kEnd,    ///< to its end
  kMiddle
};

/// An edge that may be collapsed.
struct Candidate {
  float cost;
  SideId edge;    ///< the half-edge by which the edge is known
  Index version;  ///< of the edge, when the cost was found
  CollapsePlace place;
};

/// Tells whether a candidate comes after another one: the cheapest is the first; of equal ones that
/// of the lower edge, then the earlier place.
bool is_later(const Candidate& a, const Candidate& b);

/// The candidates in their order.
class CollapseQueue {
 public:
  bool empty() const { return heap_.empty() && seen_.empty(); }
  void push(const Candidate& candidate);
  Candidate pop();

  /// Calls `visit` for the first candidates for which `counts` is true, `count` at most, in their
  /// order. They stay in the queue; those before and between them for which it is not do not.
  /// All that were looked at before must have been taken from the queue.
  template <typename Counts, typename Visit>
  void look_ahead(std::size_t count, const Counts& counts, const Visit& visit) {
    while (seen_.size() < count && !heap_.empty()) {
      const Candidate candidate = pop_heap();
      if (!counts(candidate)) continue;
      seen_.push_back(candidate);
      visit(candidate);
    }
    std::reverse(seen_.begin(), seen_.end());
  }

 private:
  Candidate pop_heap();

  std::vector<Candidate> heap_;
  std::vector<Candidate> seen_;  // those that were looked at, the last first
};

}  // namespace kdm
