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

// Tells whether the point lies before the triangle: on the side that its normal points to.
bool lies_before(const LatticeTriangle& t, const LatticePoint& p) {
  const std::array<std::int64_t, 3> normal = area_vector(t);
  std::int64_t height = 0;
  for (int i = 0; i < 3; ++i) height += normal[i] * (p[i] - t[0][i]);
  for (int i = 0; i < 3 && height == 0; ++i) height = normal[i];  // grid points are shifted upwards
  return height > 0;
}

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

// Tells whether a triangle reaches out of its cell across the axis.
bool reaches_out(const Outcodes& corners, int axis) {
  const unsigned all = corners[0] | corners[1] | corners[2];
  return (all >> 2 * axis & 3u) != 0;
}

LatticePoint nearest_in(const LatticeBox& box, const Vec3& point) {
  LatticePoint p;
  for (int i = 0; i < 3; ++i) {
    p[i] = static_cast<std::int32_t>(
        std::clamp(std::floor(point[i] + 0.5), double(box.lo[i]), double(box.hi[i])));
  }
  return p;
}

}  // namespace

void InnerTriangles::find(CellSurface& surface_in_cell, int state, const Marks& crossing) {
  const CellTriangles& cell = surface_in_cell.triangles;
  cell_ = &cell;
  state_ = state;
  surface_in_cell.inner.assign(cell.size(), {});
  find_members_apart(surface_in_cell.pieces, crossing);
  line_members_.list(cell);
  find_first_crossings();
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
    return nearest_in(cell_->cell(), point + distance * normal);
  };
  const auto inside = [&](int state) { return model_.is_inside(state).value_or(false); };
  const LatticePoint before = beside(kBeside);
  const LatticePoint behind = beside(-kBeside);
  if (!lies_before(t, before) || lies_before(t, behind)) return false;  // at the cell's side
  const int state_before = state_at(before);
  const int state_behind = state_at(behind);
  const bool inside_before = inside(state_before);
  if (inside_before == inside(state_behind)) {
    return inside_before || is_cut_off(state_before, state_behind);
  }
  return inside(state_at(beside(inside_before ? -reach_ : reach_)));
}

// Tells of the states of two points outside, on either side of a triangle, whether faces lie on
// each other there that leave nothing between them: one solid begins where another one is cut off,
// or a part that is turned inwards, such as a notch, ends where the part does that it is taken off.
bool InnerTriangles::is_cut_off(int before, int behind) const {
  if (surface_.several_solids()) return before != behind;
  return model_.leaves_slivers_out();
}

// Finds the crossings on the cell's lowest edge along axis 0, on which all ways begin.
void InnerTriangles::find_first_crossings() {
  first_crossings_.clear();
  const LatticePoint& low = cell_->cell().lo;
  line_members_.for_each(0, low, [&](MemberId m) {
    const LatticeTriangle& t = cell_->corners(m);
    const int normal = line_crosses(t, 0, low[1], low[2]);
    if (normal == 0) return;
    const std::int32_t plane = floor_of(crossing_position(t, 0, low[1], low[2]));
    if (plane >= low[0]) first_crossings_.push_back({plane, cell_->triangle(m), normal > 0});
  });
}

// Follows three grid lines from the cell's lowest corner.
int InnerTriangles::state_at(const LatticePoint& point) const {
  LatticePoint at = cell_->cell().lo;
  int state = state_;
  for (const FirstCrossing& crossing : first_crossings_) {
    if (crossing.plane >= point[0]) continue;
    state = model_.state_after(state, crossing.triangle, crossing.leaving);
  }
  at[0] = point[0];
  for (int axis = 1; axis < 3; ++axis) {
    state = follow(axis, at, point[axis], state);
    at[axis] = point[axis];
  }
  return state;
}

// Follows a grid line upwards from a point in the cell that has the given state, and returns the
// state at the end.
int InnerTriangles::follow(int axis, const LatticePoint& from, std::int32_t to, int state) const {
  const int u = next_axis(axis);
  const int v = previous_axis(axis);
  line_members_.for_each(axis, from, [&](MemberId m) {
    const LatticeBox& bounds = cell_->bounds(m);
    if (bounds.lo[axis] > to || bounds.lo[u] > from[u] || bounds.hi[u] < from[u] ||
        bounds.lo[v] > from[v] || bounds.hi[v] < from[v]) {
      return;
    }
    const LatticeTriangle& t = cell_->corners(m);
    const int normal = line_crosses(t, axis, from[u], from[v]);
    if (normal == 0) return;
    // Of a triangle that lies between the two ends the crossing need not be found.
    const bool between = bounds.lo[axis] > from[axis] && bounds.hi[axis] < to &&
                         !reaches_out(cell_->outcodes(m), axis);
    if (!between) {
      const std::int32_t plane = floor_of(crossing_position(t, axis, from[u], from[v]));
      if (plane < from[axis] || plane >= to) return;
    }
    state = model_.state_after(state, cell_->triangle(m), normal > 0);
  });
  return state;
}

}  // namespace kdm
