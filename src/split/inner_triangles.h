// SPDX-License-Identifier: MIT
// Which triangles bound nothing in a cell where shells cross or touch, since they lie within the
// union of the shells.
#pragma once

#include "inside/inside_model.h"
#include "split/cell_surface.h"

namespace kdm {

/// Looks at the corners and at the middle of a triangle's part in the cell. At each of these points
/// the states of the inside model just before and just behind the triangle are counted along grid
/// lines, exactly. Where both lie inside, the triangle bounds nothing; so it is where what lies
/// before it is a gap that is closed. What lies between the points is not looked at. One object
/// serves cell after cell.
class InnerTriangles {
 public:
  /// Gaps up to `widest_gap` lattice units are closed.
  InnerTriangles(const Surface& surface, const InsideModel& model, double widest_gap)
      : surface_(surface), model_(model), reach_(widest_gap + kBeside) {}

  /// Looks at all members of a cell and writes `cell.inner`. `state` is that of the cell's lowest
  /// corner. Takes time quadratic in the number of members.
  void find(CellSurface& cell, int state);

 private:
  // How far beside a triangle the states are looked at, lattice units: rounding moves by less.
  static constexpr double kBeside = 2;

  bool bounds_nothing(MemberId member, const Vec3& point) const;
  int state_at(const LatticePoint& point) const;
  int count_along(int axis, const LatticePoint& from, std::int32_t to) const;

  const Surface& surface_;
  const InsideModel& model_;
  double reach_;
  const CellTriangles* cell_ = nullptr;
  int state_ = 0;
};

}  // namespace kdm
