// SPDX-License-Identifier: MIT
// Gaps in the solid that are too narrow to be kept: where parts lie on each other, rounding to the
// lattice moves their faces apart in some places and into each other in others. Such gaps are
// closed, so that the contact looks the same all over.
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "grid/grid_data.h"
#include "inside/crossing.h"
#include "mesh/marks.h"
#include "prepare/surface.h"

namespace kdm {

/// Returns the width of the widest gaps that are closed, in lattice units: a thirty-second of the
/// tolerance, but no less than the four units by which rounding moves faces on each other apart.
inline double widest_gap(double tolerance) { return std::max(4.0, tolerance / 32); }

/// Says which gaps are closed, from the two crossings alone, so that all cells agree: those whose
/// two sides face each other, not those at the bottom of a valley. Between two parts of the surface
/// gaps up to `widest_gap` are closed, within one part gaps up to four lattice units. Slivers up to
/// four lattice units thick are left out as well: what two solids leave between their faces, or a
/// part that is turned inwards, such as a notch, between its faces and those of the part that it is
/// taken off.
class GapRule {
 public:
  /// The tolerance is in lattice units. `turns_count` says whether it matters which way a part is
  /// turned, so that one may be taken off another. Keeps a reference to the surface.
  GapRule(const Surface& surface, double tolerance, bool turns_count);

  /// Gives the role `kGap` to the crossings of one edge along `axis` that leave the solid and enter
  /// it again, where the gap between them is closed, and the role `kSliver` to those that enter and
  /// leave a sliver. The crossings ascend along the edge.
  void close(int axis, std::span<ClassifiedCrossing> edge) const;

  /// Tells whether there may be slivers that are left out.
  bool leaves_slivers_out() const { return surface_.several_solids() || !inward_.empty(); }

 private:
  bool cut_off(TriangleId a, TriangleId b) const;
  void find_inward_parts();
  void drop_what_is_cut_off(std::span<ClassifiedCrossing> edge) const;
  bool closes(int axis, const ClassifiedCrossing& leaving,
              const ClassifiedCrossing& entering) const;
  bool leaves_out(int axis, const ClassifiedCrossing& entering,
                  const ClassifiedCrossing& leaving) const;
  Vec3 normal_out(int axis, const ClassifiedCrossing& crossing) const;
  double width_between(int axis, const ClassifiedCrossing& low,
                       const ClassifiedCrossing& high) const;

  const Surface& surface_;
  const std::vector<Index>& part_of_;  // per triangle; empty if there is one part
  Marks inward_;                       // per part: it is turned inwards; empty if none is
  double widest_;
};

/// Finds the crossings of the role `kGap` between which a grid vertex lies. The vertex is outside,
/// for all grid lines through it, so its gap has to stay open: both crossings become hits. The same
/// holds for `kSliver`, where the vertex is inside. Returns marks per crossing, or none at all if
/// every gap can be closed. `boxes` come from `cell_boxes`.
/// Takes time linear in the number of cells if some gap reaches across a lattice plane, else in
/// that of the crossings.
Marks find_open_gaps(const GridData& grid, const std::vector<LatticeBox>& boxes,
                     const EdgeCrossings& planned);

}  // namespace kdm
