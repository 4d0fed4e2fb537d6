// SPDX-License-Identifier: MIT
// The choice of cut: where a cell is split that does not fit, or whose topology has a fault.
#pragma once

#include <optional>

#include "split/cell_surface.h"
#include "split/feature_point.h"
#include "split/split_rules.h"
#include "split/topology_check.h"

namespace kdm {

/// Down to which size cells are split for topology.
enum class TopologyFloor {
  kAtTolerance,  ///< cuts keep a fraction of the tolerance away from the sides of cells
  kAtLattice     ///< a few lattice units are enough
};

/// Chooses splits, within limits of depth and width. All lengths are lattice units.
class CutChoice {
 public:
  /// The tolerance is 2 or more.
  CutChoice(const Surface& surface, double tolerance, int max_depth, CutPosition position);

  /// Returns the split of a cell that does not fit: through a feature or in the middle, as the
  /// position says. Returns nothing if the cell lies at the greatest depth or is too thin.
  std::optional<Split> split_for_fit(const CellView& cell);

  /// Returns the split of a cell whose topology has a fault: the plane between small parts if one
  /// is given and has room, else a plane through the middle of what is at fault. Returns nothing if
  /// the cell is at the greatest depth or too thin.
  std::optional<Split> split_for_topology(const CellView& cell, const CellSurface& surface_in_cell,
                                          const TopologyFault& fault,
                                          const std::optional<Split>& between_parts,
                                          TopologyFloor floor);

  /// Tells whether the cell is so small that faults of its topology are left in it.
  bool is_below_topology_floor(const CellSurface& surface_in_cell) const;

 private:
  std::optional<Split> halve_longest(const CellView& cell, std::int32_t min_width) const;
  std::optional<Split> split_at(const CellView& cell, int axis, std::int32_t value,
                                std::int32_t min_width) const;
  static bool has_room(const LatticeBox& box, const Split& split, std::int32_t min_width);
  LatticeBox region_of(const CellSurface& surface_in_cell, const TopologyFault& fault) const;
  LatticeBox region_without_disks(const CellSurface& surface_in_cell) const;

  const Surface& surface_;
  bool open_surface_;
  double tolerance_;
  double topology_floor_;       // least width of cells that are split for topology
  std::int32_t min_cut_width_;  // least distance of a split from the sides of its cell
  double thin_width_;           // least width of cells across a split through a fault
  int max_depth_;
  CutPosition position_;
  FeatureFinder features_;
};

}  // namespace kdm
