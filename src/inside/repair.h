// SPDX-License-Identifier: MIT
// Inside and outside of surfaces that are not closed or not turned consistently: one oracle for
// all grid vertices, and hits made to agree with it.
#pragma once

#include <unordered_map>

#include "grid/grid_data.h"
#include "inside/resolve_segment.h"
#include "prepare/surface.h"

namespace kdm {

/// What is inside depends on the position alone, so cells agree however they are split. Where the
/// surface ends, its winding numbers go on; hits there are invented.
class Repair {
 public:
  /// `threshold` as WindingField takes it, `tolerance` in lattice units.
  Repair(Surface& surface, double threshold, double tolerance);

  /// Is the grid vertex inside? Those on the root's sides are not.
  bool inside(const LatticePoint& p);

  /// Which crossings of an edge will be kept, as far as is known before the other cells' splits
  /// bring more grid vertices onto it.
  void plan_edge(const Segment& segment, std::vector<Crossing>& crossings,
                 std::vector<WalkedCrossing>& walked) {
    resolver_.resolve(segment, crossings, false, walked);
  }

  /// Winding numbers above it are inside.
  double threshold() const { return field_.threshold(); }

  /// What was asked of the field so far, see WindingField.
  std::size_t work() const { return field_.work(); }

  /// Leaves of the grid's crossings the hits: between any two grid vertices they fit both. Planes
  /// and source faces (kNone) of invented hits are added to the surface's.
  void resolve(GridData& grid);

 private:
  struct GridVertices;

  GridVertices find_vertices(const GridData& grid, const std::vector<LatticeBox>& boxes);
  void resolve_edge(const GridVertices& vertices, const Segment& edge, int number,
                    std::span<const Hit> crossings, std::vector<Hit>& hits);
  Index invented_plane(const Segment& segment, const WalkedCrossing& crossing);

  Surface& surface_;
  WindingField field_;
  SegmentResolver resolver_;
  std::unordered_map<std::uint64_t, bool> known_;  // by position; only ever looked up
  std::vector<Crossing> crossings_;
  std::vector<WalkedCrossing> walked_;
};

}  // namespace kdm
