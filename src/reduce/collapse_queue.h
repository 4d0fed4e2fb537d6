// SPDX-License-Identifier: MIT
// Which edge is collapsed next.
#pragma once

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

/// The candidates in their order: the cheapest is the first; of equal ones that of the lower edge,
/// then the earlier place. A binary heap.
class CollapseQueue {
 public:
  bool empty() const { return heap_.empty(); }
  void push(const Candidate& candidate);
  Candidate pop();

 private:
  std::vector<Candidate> heap_;
};

}  // namespace kdm
