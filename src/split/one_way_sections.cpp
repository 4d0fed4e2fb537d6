// SPDX-License-Identifier: MIT
#include "split/one_way_sections.h"

#include <algorithm>
#include <cstdlib>

#include "geometry/predicates.h"

namespace kdm {
namespace {

// Components of area vectors are 2^40 at most; so the sum of as many vectors fits 64 bits.
constexpr Index kMostMembers = Index{1} << 22;
// The bits that are kept of a direction. Its products with area vectors fit 64 bits.
constexpr std::int64_t kMostOfDirection = std::int64_t{1} << 20;

using AreaVector = std::array<std::int64_t, 3>;

// Returns about the direction of a vector, in shorter numbers.
AreaVector shortened(AreaVector vector) {
  std::int64_t largest = 0;
  for (const std::int64_t x : vector) largest = std::max<std::int64_t>(largest, std::abs(x));
  const std::int64_t divisor = largest / kMostOfDirection + 1;
  for (std::int64_t& x : vector) x /= divisor;
  return vector;
}

// Tells whether the triangle has corners on both sides of a side's plane.
bool crosses_plane(const LatticeTriangle& t, int axis, std::int32_t plane) {
  const bool below = below_plane(t[0][axis], plane);
  return below_plane(t[1][axis], plane) != below || below_plane(t[2][axis], plane) != below;
}

}  // namespace

void OneWaySections::find(const CellSurface& cell) {
  const CellTriangles& triangles = cell.triangles;
  const bool oriented =
      !triangles.surface().has_rims() && !triangles.empty() && triangles.size() <= kMostMembers;
  one_way_ = {};
  all_face_along_ = oriented;
  if (!oriented) return;
  areas_.clear();
  AreaVector sum{};
  for (MemberId m = 0; m < triangles.size(); ++m) {
    areas_.push_back(area_vector(triangles.corners(m)));
    for (int i = 0; i < 3; ++i) sum[i] += areas_.back()[i];
  }
  const AreaVector direction = shortened(sum);
  for (auto& sides : one_way_) sides = {true, true};
  const LatticeBox& box = triangles.cell();
  for (MemberId m = 0; m < triangles.size(); ++m) {
    AreaVector part;
    for (int i = 0; i < 3; ++i) part[i] = areas_[m][i] * direction[i];
    const std::int64_t along = part[0] + part[1] + part[2];
    all_face_along_ = all_face_along_ && along > 0;
    for (int axis = 0; axis < 3; ++axis) {
      if (along - part[axis] > 0) continue;
      const LatticeBox& bounds = triangles.bounds(m);
      const LatticeTriangle& t = triangles.corners(m);
      if (bounds.lo[axis] == box.lo[axis] && crosses_plane(t, axis, box.lo[axis])) {
        one_way_[axis][0] = false;
      }
      if (bounds.hi[axis] == box.hi[axis] && crosses_plane(t, axis, box.hi[axis])) {
        one_way_[axis][1] = false;
      }
    }
  }
}

bool OneWaySections::are_of_a_graph(const CellSurface& cell) const {
  if (!all_face_along_ || cell.pieces.all().size() != 1 || cell.pieces.some_are_inner() ||
      !cell.pieces.are_disks()) {
    return false;
  }
  for (int axis = 0; axis < 3; ++axis) {
    for (const bool high : {false, true}) {
      if (!run_one_way(axis, high)) return false;
      if (cell.crossings.around_face[axis][high ? 1 : 0] > 2) return false;
    }
  }
  return true;
}

}  // namespace kdm
