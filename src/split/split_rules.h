// SPDX-License-Identifier: MIT
// Where a cell is split, or that it stays a leaf (paper 5.1.2): what every rule is asked.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "inside/crossing.h"
#include "kdmanifold/build.h"
#include "prepare/surface.h"
#include "split/triangle_lists.h"

namespace kdm {

struct Split {
  int axis;
  std::int32_t value;
};

/// What a rule carries from a cell to its children: its own ordering's range.
using RuleRange = ListRange;

/// The crossings on an edge of a cell: a range of `EdgeCrossings::all`. Empty if the edge is part
/// of the root cell's edges.
struct EdgeRange {
  Index begin = 0;
  Index end = 0;
};

/// The twelve edges of a cell: number 4 * axis + bits; bit 0: at the high end of the next axis,
/// bit 1: at the high end of the previous axis.
using CellEdges = std::array<EdgeRange, 12>;

constexpr int cell_edge(int axis, bool high_next, bool high_previous) {
  return 4 * axis + (high_next ? 1 : 0) + (high_previous ? 2 : 0);
}

/// A cell that may be split, as construction shows it to a rule.
struct CellView {
  const LatticeBox& box;
  int depth;
  std::span<const ListEntry> entries;  ///< triangles that may reach the cell, at least one
  RuleRange range;                     ///< the range that the rule gave the cell by `divide`
  const CellEdges& edges;              ///< where the cell's crossings are among `crossings`
  const std::vector<ClassifiedCrossing>& crossings;  ///< all that were found so far
};

/// One object serves the whole construction; it is asked about cells in depth-first order.
class SplitRule {
 public:
  virtual ~SplitRule() = default;
  /// The range that the root cell has.
  virtual RuleRange root() { return {}; }
  virtual std::optional<Split> choose(const CellView& cell) = 0;
  /// Ranges of the two children of a split cell.
  virtual std::array<RuleRange, 2> divide(RuleRange range, const Split& split) {
    static_cast<void>(split);
    return {range, range};
  }
  /// A grid edge has met this triangle.
  virtual void on_crossing(Index triangle) { static_cast<void>(triangle); }
  /// What the rule can say of the grid once all cells are made.
  virtual void report(GridStats& stats) const { static_cast<void>(stats); }
};

/// The middle of the box along the axis whose turn it is; nothing once that is one unit wide.
std::optional<Split> midpoint_in_turn(const LatticeBox& box, int depth);

/// Where the adaptive rule splits a cell that does not fit.
enum class CutPosition {
  kHalving,  ///< in the middle of its longest side
  kInTurn,   ///< in the middle, x, y, z in turn: an octree
  kFeature   ///< through or near features, paper 5.1.2 (2)
};

/// `tolerance` in lattice units.
std::unique_ptr<SplitRule> make_split_rule(const Surface& surface, const BuildOptions& options,
                                           double tolerance, int depth);
std::unique_ptr<SplitRule> make_adaptive_rule(const Surface& surface, double tolerance, int depth,
                                              CutPosition position);

}  // namespace kdm
