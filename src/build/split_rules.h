// SPDX-License-Identifier: MIT
// Where a cell is split, or that it stays a leaf (paper 5.1.2).
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "build/surface.h"
#include "build/triangle_lists.h"
#include "kdmanifold/build.h"

namespace kdm {

struct Split {
  int axis;
  std::int32_t value;
};

/// What a rule carries from a cell to its children: its own ordering's range.
using RuleRange = ListRange;

/// One object serves the whole construction; it is asked about cells in depth-first order.
class SplitRule {
 public:
  virtual ~SplitRule() = default;
  /// The range that the root cell has.
  virtual RuleRange root() { return {}; }
  /// `entries` are the triangles that reach the cell, at least one.
  virtual std::optional<Split> choose(const LatticeBox& box, int depth,
                                      std::span<const ListEntry> entries, RuleRange range) = 0;
  /// Ranges of the two children of a split cell.
  virtual std::array<RuleRange, 2> divide(RuleRange range, const Split& split) {
    static_cast<void>(split);
    return {range, range};
  }
  /// A grid edge has met this triangle.
  virtual void on_crossing(Index triangle) { static_cast<void>(triangle); }
};

std::unique_ptr<SplitRule> make_split_rule(const Surface& surface, const BuildOptions& options);

}  // namespace kdm
