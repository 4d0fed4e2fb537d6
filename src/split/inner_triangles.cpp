// SPDX-License-Identifier: MIT
#include "split/inner_triangles.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "geometry/triangle_box.h"

namespace kdm {
namespace {

// Points are moved by this part of the way from a corner to the middle, off the edges.
constexpr double kInset = 1.0 / 16;
// Of a part that is less wide, lattice units, these points are too near to its edges to speak for
// other triangles.
constexpr double kLeastWidth = 64;

// Tells whether the polygon is wide enough to speak for others.
bool is_wide(const ClippedPolygon& polygon) {
  Vec3 area = Vec3::Zero();
  double longest = 0;
  for (int i = 1; i < polygon.size; ++i) {
    const Vec3 side = polygon.corners[i] - polygon.corners[0];
    longest = std::max(longest, side.norm());
    if (i + 1 < polygon.size) area += side.cross(polygon.corners[i + 1] - polygon.corners[0]);
  }
  return area.norm() > kLeastWidth * longest;
}

}  // namespace

void InnerTriangles::find(CellSurface& surface_in_cell, const Marks& crossing) {
  const CellTriangles& cell = surface_in_cell.triangles;
  cell_ = &cell;
  surface_in_cell.inner.assign(cell.size(), {});
  find_members_apart(surface_in_cell.pieces, crossing);
  answer_of_.assign(cell.size(), std::nullopt);
  for (MemberId m = 0; m < cell.size(); ++m) {
    const bool apart = !apart_.empty() && groups_.contains(m);
    if (!apart) {
      look_at(m, surface_in_cell.inner[m]);
      continue;
    }
    std::optional<bool>& answer = answer_of_[groups_.lowest(m)];
    if (!answer) {
      InnerPart inner;
      if (look_at(m, inner)) answer = inner.all;
    }
  }
  for (const MemberId m : apart_) {
    if (answer_of_[groups_.lowest(m)].value_or(false)) surface_in_cell.inner[m] = {~0u, true};
  }
  for (const CellCrossing& crossing_of_edge : surface_in_cell.crossings.all) {
    const MemberId m = cell.member_of(crossing_of_edge.triangle);
    if (crossing_of_edge.kept && m != kNone) surface_in_cell.inner[m].all = false;
  }
}

// Looks at a member by itself. Returns whether it may speak for others that it hangs together with.
bool InnerTriangles::look_at(MemberId member, InnerPart& inner) const {
  if (surface_.degenerate.test(cell_->triangle(member))) {
    inner.all = true;
    return false;
  }
  const ClippedPolygon part = clip_to_box(cell_->corners(member), cell_->cell());
  if (part.size == 0) return false;
  Vec3 middle = Vec3::Zero();
  for (int i = 0; i < part.size; ++i) middle += part.corners[i];
  middle /= part.size;
  inner.all = bounds_nothing(member, middle);
  for (int i = 0; i < part.size; ++i) {
    const Vec3& corner = part.corners[i];
    const bool nothing = bounds_nothing(member, corner + kInset * (middle - corner));
    inner.corners |= nothing ? 1u << i : 0;
    inner.all = inner.all && nothing;
  }
  return is_wide(part);
}

void InnerTriangles::find_members_apart(const CellPieces& pieces, const Marks& crossing) {
  apart_.clear();
  for (MemberId m = 0; m < cell_->size(); ++m) {
    const bool degenerate = surface_.degenerate.test(cell_->triangle(m));
    if (!degenerate && !crossing.test(m) && !near_another(pieces, m)) apart_.push_back(m);
  }
  groups_.connect(*cell_, apart_);
}

// Tells whether a triangle of another solid, or of one solid another piece, may lie where states
// are looked at.
bool InnerTriangles::near_another(const CellPieces& pieces, MemberId member) const {
  const auto belong_together = [&](MemberId m) {
    return surface_.several_solids()
               ? surface_.solid_of[cell_->triangle(m)] == surface_.solid_of[cell_->triangle(member)]
               : pieces.piece_of(m) == pieces.piece_of(member);
  };
  const LatticeBox& bounds = cell_->bounds(member);
  const auto reach = static_cast<std::int32_t>(reach_) + 1;
  for (MemberId m = 0; m < cell_->size(); ++m) {
    const LatticeBox& other = cell_->bounds(m);
    bool near = true;
    for (int i = 0; i < 3; ++i) {
      near = near && other.lo[i] <= bounds.hi[i] + reach && other.hi[i] + reach >= bounds.lo[i];
    }
    if (near && !belong_together(m)) return true;
  }
  return false;
}

bool InnerTriangles::bounds_nothing(MemberId member, const Vec3& point) const {
  const LatticeTriangle& t = cell_->corners(member);
  const Vec3& normal = surface_.planes[cell_->triangle(member)].normal;
  const auto beside = [&](double distance) {
    return nearest_point_in(cell_->cell(), point + distance * normal);
  };
  const LatticePoint before = beside(kBeside);
  const LatticePoint behind = beside(-kBeside);
  if (!lies_before(t, before) || lies_before(t, behind)) return false;  // at the cell's side
  const int state_before = states_.at(before);
  const int state_behind = states_.at(behind);
  const bool inside_before = states_.is_inside(state_before);
  if (inside_before == states_.is_inside(state_behind)) {
    return inside_before || is_cut_off(state_before, state_behind);
  }
  return states_.is_inside(states_.at(beside(inside_before ? -reach_ : reach_)));
}

// Tells of the states of two points outside, on either side of a triangle, whether faces lie on
// each other there that leave nothing between them: one solid begins where another one is cut off,
// or a part that is turned inwards, such as a notch, ends where the part does that it is taken off.
bool InnerTriangles::is_cut_off(int before, int behind) const {
  if (surface_.several_solids()) return before != behind;
  return model_.leaves_slivers_out();
}

}  // namespace kdm
