// SPDX-License-Identifier: MIT
// Pillows: parts of a grid's surface without volume, which consist of two triangles linked to each
// other on all sides, or of two quads linked so. They come about where a bulge of the surface pokes
// through one grid edge only.
#pragma once

#include <algorithm>
#include <array>
#include <span>

#include "grid/grid_data.h"

namespace kdm {

/// Finds the pillows among triangles with half-edges 3t, 3t + 1 and 3t + 2. One object serves one
/// set of links.
template <typename CrossesStrip>
class PillowFinder {
 public:
  /// `opposite` holds for each half-edge the one it is linked to, or kNone; `crosses_strip(h)`
  /// tells whether half-edge h leads to the other half of a quad.
  PillowFinder(std::span<const HalfEdgeId> opposite, const CrossesStrip& crosses_strip)
      : opposite_(opposite), crosses_strip_(crosses_strip) {}

  /// Calls `visit(triangles)` for each pillow. A triangle may be listed twice.
  template <typename Visit>
  void for_each(const Visit& visit) const {
    for (Index t = 0; t < opposite_.size() / 3; ++t) {
      const Index behind = behind_of(t);
      if (behind == kNone || behind == t || behind_of(behind) != t) continue;
      const Index partner = across_strip(t);
      const Index behind_partner = across_strip(behind);
      if ((partner == kNone) != (behind_partner == kNone)) continue;
      if (partner == kNone) {
        if (t < behind) visit(std::array{t, behind});
        continue;
      }
      if (behind_of(partner) != behind_partner || behind_of(behind_partner) != partner) continue;
      if (t > std::min({behind, partner, behind_partner})) continue;
      visit(std::array{t, partner, behind, behind_partner});
    }
  }

 private:
  // Returns the triangle that all half-edges lead to which cross no strip; kNone if these are
  // several, or one is not linked.
  Index behind_of(Index t) const {
    Index behind = kNone;
    for (HalfEdgeId h = 3 * t; h < 3 * t + 3; ++h) {
      if (crosses_strip_(h)) continue;
      if (opposite_[h] == kNone) return kNone;
      const Index other = opposite_[h] / 3;
      if (behind != kNone && other != behind) return kNone;
      behind = other;
    }
    return behind;
  }

  Index across_strip(Index t) const {
    for (HalfEdgeId h = 3 * t; h < 3 * t + 3; ++h) {
      if (crosses_strip_(h) && opposite_[h] != kNone) return opposite_[h] / 3;
    }
    return kNone;
  }

  std::span<const HalfEdgeId> opposite_;
  const CrossesStrip& crosses_strip_;
};

/// Tells whether the grid's surface has pillows. Extraction drops them.
inline bool has_pillows(const GridData& grid) {
  const auto crosses_strip = [&](HalfEdgeId h) { return grid.crosses_strip(h); };
  bool found = false;
  PillowFinder(grid.opposite, crosses_strip).for_each([&](const auto&) { found = true; });
  return found;
}

}  // namespace kdm
