// SPDX-License-Identifier: MIT
// Crossings: the intersections of the input's triangles with grid edges, from which hits are made.
//
// A crossing goes through three forms. `Crossing` is what the search along an edge finds.
// `ClassifiedCrossing` adds what the inside model says of it; construction keeps these until all
// cells are made. `HitWriter` then turns those that bound the solid into the grid's `Hit`s.
#pragma once

#include <span>
#include <vector>

#include "geometry/predicates.h"
#include "mesh/numbers.h"

namespace kdm {

/// An intersection of a triangle with a grid edge, as the search along the edge finds it.
struct Crossing {
  LinePosition position;
  TriangleId triangle;  ///< kNone: invented where the surface has a hole
  bool leaving;         ///< the triangle's normal points up the edge
};

/// What an inside model says of a crossing.
enum class CrossingRole {
  kBounds,    ///< bounds the solid: it becomes a hit
  kInner,     ///< does not: the points just below and above it lie both inside, or both outside
  kTouching,  ///< one of several at one position that lie outside: parts of the solid touch there
  kGap,       ///< one of two that leave the solid and enter it again, so close to each other that
              ///< the gap between them is closed
  kSliver     ///< one of two that enter the solid and leave it again, so close to each other that
              ///< what lies between them is left out
};

/// A crossing and what the inside model says of it: 12 bytes, since construction keeps one for
/// every intersection.
class ClassifiedCrossing {
 public:
  ClassifiedCrossing(LinePosition position, TriangleId triangle, int state_after, CrossingRole role,
                     bool leaving)
      : position_(position),
        packed_((triangle & kTriangleMask) | (leaving ? kLeaving : 0u)),
        state_and_role_(state_after * kRoles + static_cast<int>(role)) {}

  LinePosition position() const { return position_; }
  /// Returns kNone for a crossing that was invented.
  TriangleId triangle() const {
    const TriangleId triangle = packed_ & kTriangleMask;
    return triangle == kTriangleMask ? kNone : triangle;
  }
  /// Returns the inside model's state of the points just above the crossing.
  int state_after() const { return state_and_role_ >> 3; }
  CrossingRole role() const { return static_cast<CrossingRole>(state_and_role_ & (kRoles - 1)); }
  void set_role(CrossingRole role) {
    state_and_role_ = state_after() * kRoles + static_cast<int>(role);
  }
  /// Returns whether the crossing bounds the solid (of a sheet: always), so that it becomes a hit.
  bool kept() const { return role() == CrossingRole::kBounds; }
  /// Returns whether the edge, followed upwards, leaves the solid here; this may differ from the
  /// direction of the triangle. The answer has a meaning only if the crossing bounds the solid or a
  /// gap in it.
  bool leaving() const { return (packed_ & kLeaving) != 0; }

  bool operator==(const ClassifiedCrossing&) const = default;

 private:
  static constexpr std::uint32_t kLeaving = 1u << 31;
  static constexpr std::uint32_t kTriangleMask = kLeaving - 1;  // no input has as many triangles
  static constexpr int kRoles = 8;                              // the next power of two

  LinePosition position_;
  std::uint32_t packed_;  // 31 bits of triangle, then the flag
  int state_and_role_;    // the role takes three bits
};
static_assert(sizeof(ClassifiedCrossing) == 12);

/// Tells whether a gap or a sliver begins with the crossing.
inline bool begins_gap(const ClassifiedCrossing& crossing) {
  return crossing.role() == (crossing.leaving() ? CrossingRole::kGap : CrossingRole::kSliver);
}

/// Returns the number of the crossing at which a gap or a sliver ends that begins with another one:
/// the next one of its role.
inline Index end_of_gap(const std::vector<ClassifiedCrossing>& crossings, Index begin) {
  Index end = begin + 1;
  while (crossings[end].role() != crossings[begin].role()) ++end;
  return end;
}

/// The crossings of all splitting edges that were made so far. Those of one edge are consecutive
/// and ascend along it.
struct EdgeCrossings {
  std::vector<ClassifiedCrossing> all;
  std::vector<Index> edge_begin{0};  ///< per splitting edge its first crossing; last, their number

  std::span<const ClassifiedCrossing> of(EdgeId edge) const {
    return {all.data() + edge_begin[edge], edge_begin[edge + 1] - edge_begin[edge]};
  }

  /// Appends edges with those of the other crossings that lie on its edges from `first` up to, but
  /// not including, `end`.
  void append(const EdgeCrossings& other, EdgeId first, EdgeId end) {
    const Index begin = other.edge_begin[first];
    const auto shift = static_cast<Index>(all.size()) - begin;
    all.insert(all.end(), other.all.begin() + begin, other.all.begin() + other.edge_begin[end]);
    for (EdgeId edge = first; edge < end; ++edge) {
      edge_begin.push_back(other.edge_begin[edge + 1] + shift);
    }
  }
};

}  // namespace kdm
