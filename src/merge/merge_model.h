// SPDX-License-Identifier: MIT
// The inside model of two grids that are merged.
//
// The state of a grid vertex depends on its place alone (merge/grid_solid.h), and says in which of
// the two solids it is. Between two grid vertices that follow each other on an edge, the crossings
// of each solid are made to fit the states of the two; so inside and outside agree all over the
// grid whatever rounding has done. Where an edge lies on one of the solid's own edges, its
// crossings are the hits.
#pragma once

#include "inside/gaps.h"
#include "inside/inside_model.h"
#include "merge/grid_solid.h"
#include "merge/merge_function.h"
#include "mesh/progress.h"

namespace kdm {

class MergeModel final : public InsideModel {
 public:
  /// `surface` has the triangles of both solids, the first solid's first. All are kept by
  /// reference. The tolerance is in lattice units.
  MergeModel(const GridSolid& first, const GridSolid& second, const MergeFunction& function,
             const Surface& surface, double tolerance)
      : solids_{&first, &second},
        function_(function),
        surface_(surface),
        gaps_(surface, tolerance, true) {}

  int state_at(const LatticePoint& vertex, int counted) override;
  std::optional<bool> is_inside(int state) const override { return function_.inside(state); }
  int state_after(int state, TriangleId triangle, bool leaving) override;
  void keep_relevant(int state, Marks& solids) override;
  void plan_edge(const GridEdge& edge, std::vector<Crossing>& found,
                 std::vector<ClassifiedCrossing>& planned) override;
  void finish_edges(const EdgeCrossings& planned, HitWriter& writer) override;

  /// Returns how many crossings had to be added or left out, to fit the states.
  Index fitted() const { return fitted_; }

 private:
  void plan_stretch(int axis, const LatticePoint& low, std::int32_t high, int state_low,
                    int state_high, std::vector<ClassifiedCrossing>& planned);
  void fit(int solid, int axis, const LatticePoint& low, std::int32_t high, bool inside_low,
           bool inside_high);
  void add_missing(int solid, int axis, const LatticePoint& low, std::int32_t high);

  std::array<const GridSolid*, 2> solids_;
  const MergeFunction& function_;
  const Surface& surface_;
  GapRule gaps_;
  std::array<std::vector<SolidCrossing>, 2> found_;  // of the stretch at hand
  Index fitted_ = 0;
};

}  // namespace kdm
