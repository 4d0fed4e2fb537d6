// SPDX-License-Identifier: MIT
// Walks round a triangle and round a vertex, in a mesh whose triangle t has the half-edges 3t,
// 3t+1, 3t+2.
#pragma once

#include <cstddef>
#include <iterator>

#include "mesh/numbers.h"

namespace kdm {

/// Return the half-edge after, or before, this one in its triangle.
constexpr HalfEdgeId next_in_triangle(HalfEdgeId half_edge) {
  return half_edge % 3 == 2 ? half_edge - 2 : half_edge + 1;
}
constexpr HalfEdgeId previous_in_triangle(HalfEdgeId half_edge) {
  return half_edge % 3 == 0 ? half_edge + 2 : half_edge - 1;
}

/// Visits the half-edges that start in one vertex, turning round it: a range for loops, made by
/// `DualMesh::ring`. Allocates nothing. Holds a pointer into the mesh's `opposite`.
class Ring {
 public:
  class Iterator {
   public:
    using value_type = HalfEdgeId;
    using difference_type = std::ptrdiff_t;

    Iterator() = default;
    Iterator(const HalfEdgeId* opposite, HalfEdgeId first)
        : opposite_(opposite), first_(first), at_(first) {}
    HalfEdgeId operator*() const { return at_; }
    Iterator& operator++() {
      at_ = next(opposite_, at_);
      if (at_ == first_) at_ = kNone;
      return *this;
    }
    Iterator operator++(int) {
      const Iterator before = *this;
      ++*this;
      return before;
    }
    bool operator==(const Iterator& other) const { return at_ == other.at_; }
    bool operator==(std::default_sentinel_t) const { return at_ == kNone; }

   private:
    const HalfEdgeId* opposite_ = nullptr;
    HalfEdgeId first_ = kNone;
    HalfEdgeId at_ = kNone;
  };

  Ring(const HalfEdgeId* opposite, HalfEdgeId first) : opposite_(opposite), first_(first) {}
  Iterator begin() const { return {opposite_, first_}; }
  std::default_sentinel_t end() const { return {}; }

  /// Returns the half-edge after this one in the ring round the vertex in which it starts; kNone if
  /// this one is the last before the boundary.
  static HalfEdgeId next(const HalfEdgeId* opposite, HalfEdgeId half_edge) {
    const HalfEdgeId other = opposite[half_edge];
    return other == kNone ? kNone : next_in_triangle(other);
  }

 private:
  const HalfEdgeId* opposite_;  // of the mesh
  HalfEdgeId first_;
};

}  // namespace kdm
