// SPDX-License-Identifier: MIT
#include "split/crossing_triangles.h"

#include "geometry/triangle_box.h"
#include "geometry/triangle_triangle.h"
#include "mesh/box_tree.h"
#include "mesh/sort.h"

namespace kdm {
namespace {

// Up to this many members a sweep is fast enough.
constexpr Index kMaxSweepMembers = 1024;

// Tells whether some part of the polygon lies on the plane or within rounding of it: planes are
// those before rounding, which moves a triangle by less than a lattice unit.
bool reaches_plane(const ClippedPolygon& polygon, const Plane& plane) {
  bool above = false;
  bool below = false;
  for (int i = 0; i < polygon.size; ++i) {
    const double distance = plane.signed_distance(polygon.corners[i]);
    above = above || distance > -1;
    below = below || distance < 1;
  }
  return above && below;
}

bool members_cross(const CellTriangles& triangles, MemberId i, MemberId j) {
  const Surface& surface = triangles.surface();
  const LatticeBox& bounds_i = triangles.bounds(i);
  const LatticeBox& bounds_j = triangles.bounds(j);
  for (int k = 0; k < 3; ++k) {
    if (bounds_i.lo[k] > bounds_j.hi[k] || bounds_j.lo[k] > bounds_i.hi[k]) return false;
  }
  const TriangleId a = triangles.triangle(i);
  const TriangleId b = triangles.triangle(j);
  if (surface.degenerate.test(a) || surface.degenerate.test(b)) return false;
  if (!TriangleCrossing<LatticeKernel>::test(surface.triangles[a], surface.corners[a],
                                             surface.triangles[b], surface.corners[b])) {
    return false;
  }
  // The triangles as wholes cross; they may do so outside of the cell.
  const LatticeBox& cell = triangles.cell();
  return reaches_plane(clip_to_box(surface.triangles[a], cell), surface.planes[b]) &&
         reaches_plane(clip_to_box(surface.triangles[b], cell), surface.planes[a]);
}

}  // namespace

// Calls `visit(i, j)` for two members that cross, until it returns true. Pairs for which
// `skips(i, j)` holds are not looked at.
template <typename Skips, typename Visit>
void CrossingTriangles::for_each_crossing(const CellTriangles& triangles, const Skips& skips,
                                          const Visit& visit) {
  const auto cross = [&](MemberId i, MemberId j) {
    return !skips(i, j) && members_cross(triangles, i, j);
  };
  if (triangles.size() > kMaxSweepMembers) {
    std::vector<Box> boxes;
    boxes.reserve(triangles.size());
    for (MemberId m = 0; m < triangles.size(); ++m) {
      boxes.push_back({to_vec3(triangles.bounds(m).lo), to_vec3(triangles.bounds(m).hi)});
    }
    bool enough = false;
    BoxTree(boxes).for_each_pair(
        [&](MemberId i, MemberId j) { enough = enough || (cross(i, j) && visit(i, j)); });
    return;
  }
  const int axis = longest_axis(triangles.cell());
  by_lower_bound_.clear();
  for (MemberId m = 0; m < triangles.size(); ++m) {
    by_lower_bound_.push_back(pack_pair(triangles.bounds(m).lo[axis], m));
  }
  sort_numbers(by_lower_bound_);
  for (std::size_t i = 0; i < by_lower_bound_.size(); ++i) {
    const MemberId first = second_of_pair(by_lower_bound_[i]);
    for (std::size_t j = i + 1; j < by_lower_bound_.size(); ++j) {
      const std::uint64_t other = by_lower_bound_[j];
      if (first_of_pair(other) > triangles.bounds(first).hi[axis]) break;
      const MemberId second = second_of_pair(other);
      if (cross(first, second) && visit(first, second)) return;
    }
  }
}

std::span<const CrossingPair> CrossingTriangles::find_pairs(const CellTriangles& triangles) {
  pairs_.clear();
  const auto skips_none = [](MemberId, MemberId) { return false; };
  for_each_crossing(triangles, skips_none, [&](MemberId i, MemberId j) {
    pairs_.push_back({i, j});
    return false;
  });
  return pairs_;
}

bool CrossingTriangles::exist_in(const CellTriangles& triangles) {
  bool exist = false;
  const auto skips_none = [](MemberId, MemberId) { return false; };
  for_each_crossing(triangles, skips_none, [&](MemberId, MemberId) { return exist = true; });
  return exist;
}

const Marks& CrossingTriangles::find_all(const CellTriangles& triangles) {
  crossing_.assign(triangles.size());
  const auto both_known = [&](MemberId i, MemberId j) {
    return crossing_.test(i) && crossing_.test(j);
  };
  for_each_crossing(triangles, both_known, [&](MemberId i, MemberId j) {
    crossing_.set(i);
    crossing_.set(j);
    return false;
  });
  return crossing_;
}

}  // namespace kdm
