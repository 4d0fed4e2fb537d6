// SPDX-License-Identifier: MIT
#include "reduce/collapse_queue.h"

#include <algorithm>
#include <tuple>

namespace kdm {
namespace {

// Tells whether a candidate comes after another one.
bool is_later(const Candidate& a, const Candidate& b) {
  return std::tie(a.cost, a.edge, a.place) > std::tie(b.cost, b.edge, b.place);
}

}  // namespace

void CollapseQueue::push(const Candidate& candidate) {
  heap_.push_back(candidate);
  // The standard library's heaps have the largest first.
  std::push_heap(heap_.begin(), heap_.end(), is_later);
}

Candidate CollapseQueue::pop() {
  std::pop_heap(heap_.begin(), heap_.end(), is_later);
  const Candidate candidate = heap_.back();
  heap_.pop_back();
  return candidate;
}

}  // namespace kdm
