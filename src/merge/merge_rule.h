// SPDX-License-Identifier: MIT
// Splits cells as two grids have them split, and further where both have surface.
#pragma once

#include <memory>

#include "merge/grid_solid.h"
#include "merge/merge_function.h"
#include "split/split_rules.h"

namespace kdm {

/// Where one grid alone has surface that makes a difference, a cell is split as that grid has it.
/// Where both have, it is split as one of them, by the plane that cuts fewer leaves of the other
/// with surface in them; and, where neither is split any more, as the `adaptive` rule says, as long
/// as the cell is wider than the tolerance: topology is not pursued below.
class MergeRule final : public SplitRule {
 public:
  /// Refers to the first three. The tolerance is in lattice units.
  MergeRule(const GridSolid& first, const GridSolid& second, const MergeFunction& function,
            double tolerance, std::unique_ptr<SplitRule> adaptive)
      : solids_{&first, &second},
        function_(function),
        tolerance_(tolerance),
        adaptive_(std::move(adaptive)) {}

  std::optional<Split> choose(const CellView& cell) override;
  /// Topology counts as resolved only if no leaf was split that neither grid had so, and none has
  /// surface of both.
  void report(GridStats& stats) const override {
    adaptive_->report(stats);
    stats.topology_resolved = stats.topology_resolved && joined_leaves_ == 0;
  }

 private:
  std::optional<Split> split_of(int solid, CellId node) const;
  bool same_in_both(const std::array<CellId, 2>& leaves) const;

  std::array<const GridSolid*, 2> solids_;
  const MergeFunction& function_;
  double tolerance_;
  std::unique_ptr<SplitRule> adaptive_;
  Index joined_leaves_ = 0;
};

}  // namespace kdm
