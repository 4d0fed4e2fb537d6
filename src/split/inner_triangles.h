// SPDX-License-Identifier: MIT
// Which triangles bound nothing in a cell where shells cross or touch, since they lie within the
// union of the shells.
#pragma once

#include <optional>
#include <vector>

#include "inside/inside_model.h"
#include "split/cell_states.h"
#include "split/cell_surface.h"
#include "split/member_groups.h"

namespace kdm {

/// Looks at the corners and at the middle of a triangle's part in the cell. At each of these points
/// the states of the inside model just before and just behind the triangle are counted along grid
/// lines, exactly. Where both lie inside, the triangle bounds nothing; so it is where what lies
/// before it is a gap that is closed. What lies between the points is not looked at. One object
/// serves cell after cell.
class InnerTriangles {
 public:
  /// Gaps up to `widest_gap` lattice units are closed.
  InnerTriangles(const Surface& surface, const InsideModel& model, CellStates& states,
                 double widest_gap)
      : surface_(surface), model_(model), states_(states), reach_(widest_gap + kBeside) {}

  /// Looks at all members of a cell and writes `cell.inner`. The states must have been started in
  /// the cell. `crossing` marks the members that cross others. Members that hang together, cross
  /// nothing and are near no other solid, or of one solid no other piece, have one answer, that of
  /// the first which is wide enough in the cell. Takes time quadratic in the number of members.
  void find(CellSurface& cell, const Marks& crossing);

 private:
  // How far beside a triangle the states are looked at, lattice units: rounding moves by less.
  static constexpr double kBeside = 2;

  bool look_at(MemberId member, InnerPart& inner) const;
  void find_members_apart(const CellPieces& pieces, const Marks& crossing);
  bool near_another(const CellPieces& pieces, MemberId member) const;
  bool bounds_nothing(MemberId member, const Vec3& point) const;
  bool is_cut_off(int before, int behind) const;

  const Surface& surface_;
  const InsideModel& model_;
  CellStates& states_;
  double reach_;
  const CellTriangles* cell_ = nullptr;
  std::vector<MemberId> apart_;                 // that cross nothing and are near nothing else
  MemberGroups groups_;                         // of these
  std::vector<std::optional<bool>> answer_of_;  // per lowest member of such a group: all are inner
};

}  // namespace kdm
