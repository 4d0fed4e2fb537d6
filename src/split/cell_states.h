// SPDX-License-Identifier: MIT
// The states of the inside model at lattice points in a cell.
#pragma once

#include <vector>

#include "inside/inside_model.h"
#include "split/cell_triangles.h"
#include "split/line_members.h"

namespace kdm {

/// Tells whether the point lies before the triangle, on the side that its normal points to, under
/// the perturbation of geometry/predicates.h.
bool lies_before(const LatticeTriangle& t, const LatticePoint& p);

/// Counts states along three grid lines from the cell's lowest corner, exactly. For models that
/// count. One object serves cell after cell.
class CellStates {
 public:
  explicit CellStates(InsideModel& model) : model_(model) {}

  /// Takes up a cell. `state` is that of its lowest corner. Takes time linear in its triangles.
  void start(const CellTriangles& cell, int state);
  /// Returns the state of a point in the cell, in time linear in the cell's triangles.
  int at(const LatticePoint& point) const;
  /// Returns the state beyond a member of the cell; `leaving` says whether the way leads out of its
  /// front.
  int beyond(MemberId member, int state, bool leaving) const {
    return model_.state_after(state, cell_->triangle(member), leaving);
  }
  /// Tells whether points of this state lie inside.
  bool is_inside(int state) const { return model_.is_inside(state).value_or(false); }

 private:
  void find_first_crossings();
  int follow(int axis, const LatticePoint& from, std::int32_t to, int state) const;

  // A crossing on the cell's lowest edge along axis 0.
  struct FirstCrossing {
    std::int32_t plane;  // the lattice plane below it
    TriangleId triangle;
    bool leaving;
  };

  InsideModel& model_;
  const CellTriangles* cell_ = nullptr;
  LineMembers line_members_;
  std::vector<FirstCrossing> first_crossings_;
  int state_ = 0;  // of the cell's lowest corner
};

}  // namespace kdm
