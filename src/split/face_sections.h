// SPDX-License-Identifier: MIT
// The curves in which the surface meets the faces of a cell, and which of them are closed.
#pragma once

#include <optional>
#include <vector>

#include "mesh/marks.h"
#include "split/cell_surface.h"
#include "split/member_groups.h"
#include "split/one_way_sections.h"

namespace kdm {

/// A curve in which the surface meets a face of the cell and that does not cross the cell's edges:
/// it is closed (paper fig. 8a), or leads from rim to rim.
struct ClosedCurve {
  int axis;            ///< normal to the face
  LatticeBox section;  ///< bounds of the curve, or of all triangles on the face if no curve of its
                       ///< own is closed
  PieceId piece;       ///< that the curve is of, or the first on the face
};

/// Searches the six faces of a cell for closed curves. One object serves cell after cell.
class FaceSections {
 public:
  /// Returns a closed curve of the first face that has one. A face has one if the surface meets it
  /// in more connected curves than can have ends: an end is a crossing on the face's outline or a
  /// point of the surface's rim. Faces whose curves run one way are not looked at: they have none.
  std::optional<ClosedCurve> find_closed_curve(const CellSurface& cell,
                                               const OneWaySections& one_way);

 private:
  std::optional<ClosedCurve> find_on_face(const CellSurface& cell, int axis, bool high);
  static Index ends_around(const CellSurface& cell, int axis, bool high);
  bool curve_joins_two_rims(const CellTriangles& triangles);
  ClosedCurve closed_curve(const CellSurface& cell, int axis, bool high);
  LatticeBox section_bounds(const CellTriangles& triangles, MemberId curve, int axis,
                            std::int32_t plane);

  std::vector<MemberId> on_face_;  // members that meet the face at hand
  MemberGroups curves_;            // these, grouped by the curves of the section
  Marks has_end_;                  // per lowest member of a curve
};

}  // namespace kdm
