// SPDX-License-Identifier: MIT
#include "split/face_sections.h"

#include <algorithm>
#include <cmath>

namespace kdm {

std::optional<ClosedCurve> FaceSections::find_closed_curve(const CellSurface& cell,
                                                           const OneWaySections& one_way) {
  for (int axis = 0; axis < 3; ++axis) {
    for (const bool high : {false, true}) {
      if (one_way.run_one_way(axis, high)) continue;
      if (const std::optional<ClosedCurve> curve = find_on_face(cell, axis, high)) return curve;
    }
  }
  return std::nullopt;
}

std::optional<ClosedCurve> FaceSections::find_on_face(const CellSurface& cell, int axis,
                                                      bool high) {
  const CellTriangles& triangles = cell.triangles;
  const LatticeBox& box = triangles.cell();
  const LatticeBox face = triangles.face(axis, high);
  on_face_.clear();
  for (MemberId m = 0; m < triangles.size(); ++m) {
    const LatticeBox& bounds = triangles.bounds(m);
    const bool reaches = high ? bounds.hi[axis] == box.hi[axis] : bounds.lo[axis] == box.lo[axis];
    if (!reaches || cell.pieces.all()[cell.pieces.piece_of(m)].is_inner) continue;
    const Outcodes codes = triangles.outcodes_at_face(m, axis, high);
    if (triangle_meets_box(triangles.corners(m), codes, face)) on_face_.push_back(m);
  }
  if (on_face_.empty()) return std::nullopt;
  curves_.connect_on_face(triangles, on_face_, axis, high);
  const Index ends = ends_around(cell, axis, high) + static_cast<Index>(curves_.rim_sides().size());
  if (curves_.count() == ends / 2 && !curve_joins_two_rims(triangles)) return std::nullopt;
  return closed_curve(cell, axis, high);
}

// Returns how many crossings of pieces that bound the solid lie around the face.
Index FaceSections::ends_around(const CellSurface& cell, int axis, bool high) {
  if (!cell.pieces.some_are_inner()) return cell.crossings.around_face[axis][high ? 1 : 0];
  Index ends = 0;
  for (const CellCrossing& crossing : cell.crossings.all) {
    if (!edge_bounds_face(crossing.edge, axis, high)) continue;
    const PieceId piece = cell.piece_of_triangle(crossing.triangle);
    if (piece == kNone || !cell.pieces.all()[piece].is_inner) ++ends;
  }
  return ends;
}

// Returns the first curve on the face that has no end. Where each has one, which happens where a
// curve leads from rim to rim, all of them are taken together.
ClosedCurve FaceSections::closed_curve(const CellSurface& cell, int axis, bool high) {
  const CellTriangles& triangles = cell.triangles;
  has_end_.assign(triangles.size());
  const auto end_at = [&](TriangleId triangle) {
    const MemberId m = triangles.member_of(triangle);
    if (m != kNone && curves_.contains(m)) has_end_.set(curves_.lowest(m));
  };
  for (const CellCrossing& crossing : cell.crossings.all) {
    if (edge_bounds_face(crossing.edge, axis, high)) end_at(crossing.triangle);
  }
  for (const SideId side : curves_.rim_sides()) end_at(triangle_of(side));
  for (const MemberId m : on_face_) {
    const MemberId curve = curves_.lowest(m);
    if (has_end_.test(curve)) continue;
    const std::int32_t plane = (high ? triangles.cell().hi : triangles.cell().lo)[axis];
    return {axis, section_bounds(triangles, curve, axis, plane), cell.pieces.piece_of(m)};
  }
  LatticeBox bounds = triangles.bounds(on_face_[0]);
  for (const MemberId m : on_face_) widen(bounds, triangles.bounds(m));
  return {axis, bounds, cell.pieces.piece_of(on_face_[0])};
}

// Returns the bounds of one curve within the face, rounded outwards. They are often much smaller
// than those of its triangles, which may reach far into the cell.
LatticeBox FaceSections::section_bounds(const CellTriangles& triangles, MemberId curve, int axis,
                                        std::int32_t plane) {
  const LatticeBox& cell = triangles.cell();
  LatticeBox bounds{cell.hi, cell.lo};
  for (const MemberId m : on_face_) {
    if (curves_.lowest(m) != curve) continue;
    const LatticeTriangle& t = triangles.corners(m);
    for (int i = 0; i < 3; ++i) {
      const LatticePoint& a = t[i];
      const LatticePoint& b = t[next_corner(i)];
      if (below_plane(a[axis], plane) == below_plane(b[axis], plane)) continue;
      const Vec3 point = to_vec3(a) + static_cast<double>(plane - a[axis]) / (b[axis] - a[axis]) *
                                          (to_vec3(b) - to_vec3(a));
      for (int k = 0; k < 3; ++k) {
        const double x = std::clamp<double>(point[k], cell.lo[k], cell.hi[k]);
        bounds.lo[k] = std::min(bounds.lo[k], static_cast<std::int32_t>(std::floor(x)));
        bounds.hi[k] = std::max(bounds.hi[k], static_cast<std::int32_t>(std::ceil(x)));
      }
    }
  }
  return bounds;
}

bool FaceSections::curve_joins_two_rims(const CellTriangles& triangles) {
  const std::span<const SideId> sides = curves_.rim_sides();
  const auto curve_of = [&](SideId side) {
    return curves_.lowest(triangles.member_of(triangle_of(side)));
  };
  for (std::size_t i = 1; i < sides.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (curve_of(sides[i]) == curve_of(sides[j])) return true;
    }
  }
  return false;
}

}  // namespace kdm
