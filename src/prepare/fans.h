// SPDX-License-Identifier: MIT
// The fans that sides without an opposite cut a surface's corners into.
#pragma once

#include <span>
#include <vector>

#include "kdmanifold/types.h"
#include "mesh/numbers.h"
#include "mesh/sides.h"

namespace kdm {

/// Numbers fans: the triangles round a vertex that follow each other across joined sides. A fan
/// ends where a side has no opposite, or goes all the way round its vertex. Every corner of a
/// triangle is in one fan. Corners have the numbers of the sides that start from them.
class Fans {
 public:
  /// `opposite` says for each side which side it is joined to, or `kNone`.
  explicit Fans(std::span<const SideId> opposite) : fan_(opposite.size(), kNone) {
    for (SideId corner = 0; corner < opposite.size(); ++corner) {
      if (fan_[corner] != kNone) continue;
      // Go back to where the fan begins, unless it goes all the way round.
      SideId first = corner;
      while (opposite[first] != kNone && next_side(opposite[first]) != corner) {
        first = next_side(opposite[first]);
      }
      if (opposite[first] != kNone) first = corner;
      SideId last = first;
      for (SideId at = first; at != kNone && fan_[at] == kNone;) {
        fan_[at] = size();
        last = at;
        at = opposite[previous_side(at)];
      }
      ends_.push_back({first, last});
    }
  }

  Index size() const { return static_cast<Index>(ends_.size()); }
  /// Returns the fan of a corner.
  Index of(SideId corner) const { return fan_[corner]; }
  /// Returns the first corner of a fan.
  SideId first(Index fan) const { return ends_[fan].first; }
  /// Returns the last corner of a fan. The fan ends at the side before it, if it ends at all.
  SideId last(Index fan) const { return ends_[fan].last; }

  /// Calls `visit` with each corner of a fan, in turn; `opposite` must be what the fans were made
  /// of.
  template <class Visit>
  void for_each_corner(Index fan, std::span<const SideId> opposite, const Visit& visit) const {
    for (SideId at = first(fan);; at = opposite[previous_side(at)]) {
      visit(at);
      if (at == last(fan)) return;
    }
  }

 private:
  struct Ends {
    SideId first;
    SideId last;
  };

  std::vector<Index> fan_;  // per corner
  std::vector<Ends> ends_;  // per fan
};

/// Cuts a triangle off from its neighbours and returns how many sides were cut.
inline Index cut_round(TriangleId triangle, std::vector<SideId>& opposite) {
  Index cuts = 0;
  for (SideId side = 3 * triangle; side < 3 * triangle + 3; ++side) {
    if (opposite[side] == kNone) continue;
    opposite[opposite[side]] = kNone;
    opposite[side] = kNone;
    ++cuts;
  }
  return cuts;
}

}  // namespace kdm
