// SPDX-License-Identifier: MIT
// Split rules decide where a cell is split, or that it stays a leaf (paper 5.1.2). Construction
// asks a rule about each cell, from the root down: it shows the rule a `CellView` and gets a
// `Split` or nothing.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "inside/crossing.h"
#include "inside/inside_model.h"
#include "kdmanifold/build.h"
#include "mesh/numbers.h"
#include "prepare/surface.h"
#include "split/triangle_lists.h"

namespace kdm {

/// A plane that divides a cell in two.
struct Split {
  int axis;            ///< normal to the plane
  std::int32_t value;  ///< lattice coordinate, strictly between the cell's sides
};

/// A range of numbers that a rule gives to each cell, for instance of the triangles that the rule
/// counts as the cell's. Only the rule knows what the numbers mean.
using RuleRange = ListRange;

/// The crossings on an edge of a cell: a range of numbers of `CellView::crossings`. It is empty if
/// the edge lies on an edge of the root cell.
struct EdgeRange {
  Index begin = 0;
  Index end = 0;
};

/// The crossings on the twelve edges of a cell, numbered as `cell_edge` does.
using CellEdges = std::array<EdgeRange, 12>;

/// Returns the number of a cell's edge along `axis`: 4 * axis, plus 1 if the edge lies at the high
/// side of the cell across the next axis, plus 2 if it lies at the high side across the previous
/// axis.
constexpr int cell_edge(int axis, bool high_next, bool high_previous) {
  return 4 * axis + (high_next ? 1 : 0) + (high_previous ? 2 : 0);
}

/// A cell that may be split, as construction shows it to a rule.
struct CellView {
  const LatticeBox& box;
  int depth;                           ///< splits between the root cell and this cell
  std::span<const ListEntry> entries;  ///< triangles that may reach the cell, at least one
  RuleRange range;                     ///< the rule's own range for the cell, from `divide`
  const CellEdges& edges;              ///< which of `crossings` lie on the edges of the cell
  const std::vector<ClassifiedCrossing>& crossings;  ///< all that were found so far in the grid
  int state = 0;                                     ///< the inside model's, at the lowest corner
};

/// Decides for each cell where it is split. One object serves the whole construction of a grid; it
/// is asked about the cells in depth-first order, lower children first.
class SplitRule {
 public:
  virtual ~SplitRule() = default;
  /// Returns the rule's range for the root cell.
  virtual RuleRange root() { return {}; }
  /// Returns where the cell is split, or nothing if it stays a leaf.
  virtual std::optional<Split> choose(const CellView& cell) = 0;
  /// Returns the rule's ranges for the lower and the upper child of a cell, from the cell's range.
  virtual std::array<RuleRange, 2> divide(RuleRange range, const Split& split) {
    static_cast<void>(split);
    return {range, range};
  }
  /// Tells the rule that a grid edge crosses a triangle.
  virtual void on_crossing(TriangleId triangle) { static_cast<void>(triangle); }

  /// Tells whether all that the rule has said of a cell followed from the surface in the cell and
  /// from the crossings on its edges, so that it would say the same of a cell like it. If so, cells
  /// like others that were seen before need not be shown to the rule: `count_cells` is enough.
  virtual bool is_local() const { return false; }
  /// What a local rule counts.
  struct Tally {
    Index unresolved = 0;         ///< leaves that do not pass the tests
    std::size_t fine_splits = 0;  ///< splits of which there is a limited number
  };
  virtual Tally tally() const { return {}; }
  /// Tells whether the rule stays local if so many more fine splits are counted.
  virtual bool has_budget(std::size_t fine_splits) const { return fine_splits == 0; }
  /// Counts cells that are not shown to the rule: the fine splits in them, and the centres of the
  /// leaves that do not pass the tests, in their order.
  virtual void count_cells(std::size_t fine_splits, std::span<const Vec3> unresolved) {
    static_cast<void>(fine_splits);
    static_cast<void>(unresolved);
  }

  /// Writes what the rule knows about the grid to `stats`, after the last cell was made.
  virtual void report(GridStats& stats) const { static_cast<void>(stats); }
};

/// Returns the middle of a cell, in lattice units.
inline Vec3 centre_of(const LatticeBox& box) { return 0.5 * (to_vec3(box.lo) + to_vec3(box.hi)); }

/// Returns the split through the middle of the box across axis `depth % 3`, or nothing if the box
/// is one lattice unit wide along that axis.
std::optional<Split> midpoint_in_turn(const LatticeBox& box, int depth);

/// Returns the value of the split, moved off the gaps on the cell's edges: a grid vertex in a gap
/// would keep it open. Where there is no room it stays.
std::int32_t off_gaps(const CellView& cell, const Split& split);

/// Says where the adaptive rule splits a cell whose surface does not fit.
enum class CutPosition {
  kHalving,  ///< in the middle of the cell's longest extent
  kInTurn,   ///< in the middle across x, y and z in turn, which makes an octree
  kFeature   ///< through or near feature points (paper 5.1.2 (2)), or halving if there are none
};

/// Makes the rule that `options.strategy` names. `tolerance` is in lattice units; cells at depth
/// `depth` are not split. The rule keeps references to the surface and to the model.
std::unique_ptr<SplitRule> make_split_rule(const Surface& surface, InsideModel& model,
                                           const BuildOptions& options, double tolerance,
                                           int depth);

/// Makes the adaptive rule. It splits cells until the surface in each is met within `tolerance`
/// (lattice units) and keeps its topology, but no cells at depth `depth`. With a tolerance of 0, of
/// the cells at this depth only those count as unresolved that do not keep the topology. The rule
/// keeps references to the surface and to the model.
std::unique_ptr<SplitRule> make_adaptive_rule(const Surface& surface, InsideModel& model,
                                              double tolerance, int depth, CutPosition position);

}  // namespace kdm
