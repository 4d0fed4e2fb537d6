// SPDX-License-Identifier: MIT
#include "split/inner_triangles.h"

#include <algorithm>
#include <cmath>

#include "geometry/triangle_box.h"

namespace kdm {
namespace {

// Points are moved by this part of the way from a corner to the middle, off the edges.
constexpr double kInset = 1.0 / 16;

// Tells whether the point lies before the triangle: on the side that its normal points to.
bool lies_before(const LatticeTriangle& t, const LatticePoint& p) {
  const std::array<std::int64_t, 3> normal = area_vector(t);
  std::int64_t height = 0;
  for (int i = 0; i < 3; ++i) height += normal[i] * (p[i] - t[0][i]);
  for (int i = 0; i < 3 && height == 0; ++i) height = normal[i];  // grid points are shifted upwards
  return height > 0;
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

void InnerTriangles::find(CellSurface& surface_in_cell, int state) {
  const CellTriangles& cell = surface_in_cell.triangles;
  cell_ = &cell;
  state_ = state;
  surface_in_cell.inner.assign(cell.size(), {});
  for (MemberId m = 0; m < cell.size(); ++m) {
    if (surface_.degenerate.test(cell.triangle(m))) {
      surface_in_cell.inner[m].all = true;
      continue;
    }
    const ClippedPolygon part = clip_to_box(cell.corners(m), cell.cell());
    if (part.size == 0) continue;
    Vec3 middle = Vec3::Zero();
    for (int i = 0; i < part.size; ++i) middle += part.corners[i];
    middle /= part.size;
    InnerPart& inner = surface_in_cell.inner[m];
    inner.all = bounds_nothing(m, middle);
    for (int i = 0; i < part.size; ++i) {
      const Vec3& corner = part.corners[i];
      const bool nothing = bounds_nothing(m, corner + kInset * (middle - corner));
      inner.corners |= nothing ? 1u << i : 0;
      inner.all = inner.all && nothing;
    }
  }
  for (const CellCrossing& crossing : surface_in_cell.crossings.all) {
    const MemberId m = cell.member_of(crossing.triangle);
    if (crossing.kept && m != kNone) surface_in_cell.inner[m].all = false;
  }
}

bool InnerTriangles::bounds_nothing(MemberId member, const Vec3& point) const {
  const LatticeTriangle& t = cell_->corners(member);
  const Vec3& normal = surface_.planes[cell_->triangle(member)].normal;
  const auto beside = [&](double distance) {
    return nearest_in(cell_->cell(), point + distance * normal);
  };
  const auto inside = [&](const LatticePoint& p) {
    return model_.is_inside(state_at(p)).value_or(false);
  };
  const LatticePoint before = beside(kBeside);
  const LatticePoint behind = beside(-kBeside);
  if (!lies_before(t, before) || lies_before(t, behind)) return false;  // at the cell's side
  const bool inside_before = inside(before);
  const bool inside_behind = inside(behind);
  if (inside_before == inside_behind) return inside_before;
  return inside(beside(inside_before ? -reach_ : reach_));
}

// Follows three grid lines from the cell's lowest corner.
int InnerTriangles::state_at(const LatticePoint& point) const {
  LatticePoint at = cell_->cell().lo;
  int state = state_;
  for (int axis = 0; axis < 3; ++axis) {
    state += count_along(axis, at, point[axis]);
    at[axis] = point[axis];
  }
  return state;
}

// Returns how the state changes along a grid line, upwards from a point in the cell.
int InnerTriangles::count_along(int axis, const LatticePoint& from, std::int32_t to) const {
  const int u = next_axis(axis);
  const int v = previous_axis(axis);
  int change = 0;
  for (MemberId m = 0; m < cell_->size(); ++m) {
    const LatticeBox& bounds = cell_->bounds(m);
    if (bounds.lo[axis] > to || bounds.lo[u] > from[u] || bounds.hi[u] < from[u] ||
        bounds.lo[v] > from[v] || bounds.hi[v] < from[v]) {
      continue;
    }
    const LatticeTriangle& t = cell_->corners(m);
    const int normal = line_crosses(t, axis, from[u], from[v]);
    if (normal == 0) continue;
    const std::int32_t plane = floor_of(crossing_position(t, axis, from[u], from[v]));
    if (plane < from[axis] || plane >= to) continue;
    change += normal > 0 ? -1 : 1;
  }
  return change;
}

}  // namespace kdm
