// SPDX-License-Identifier: MIT
// Finds the point of a leaf with the least squares of distances to planes.
#include "extract/place/vertex_position.h"

#include <cmath>
#include <vector>

#include "geometry/quadric.h"

namespace kdm {
namespace {

// Returns the hits of a loop, but hits of coincident edges, which have one point and one plane,
// once. Their number depends on how neighbouring leaves are split, which must not move a vertex
// away from where the split rule expects it.
std::vector<Index> without_repeats(const GridView& view, std::span<const Index> hits) {
  std::vector<Index> once;
  once.reserve(hits.size());
  Index before = hits.back();
  for (const Index h : hits) {
    const bool again = h != before && view.grid.hits[h].plane() == view.grid.hits[before].plane() &&
                       view.hit_points[h] == view.hit_points[before];
    if (!again) once.push_back(h);
    before = h;
  }
  if (once.empty()) once.assign(hits.begin(), hits.end());
  return once;
}

}  // namespace

double distance_to_planes(const GridData& grid, std::span<const Index> hits, const Vec3& vertex) {
  double largest = 0;
  for_each_plane(grid, hits,
                 [&](const Plane& plane) { largest = std::max(largest, plane.distance(vertex)); });
  return largest;
}

Vec3 vertex_position(const GridView& view, std::span<const Index> hits, const LatticeBox& box,
                     VertexPosition position) {
  const GridData& grid = view.grid;
  const std::vector<Index> once = without_repeats(view, hits);
  Vec3 sum = Vec3::Zero();
  for (const Index h : once) sum += view.hit_points[h];
  const Vec3 centre = sum / static_cast<double>(once.size());
  PrimalQuadric quadric(centre);
  for_each_plane(grid, once, [&](const Plane& plane) { quadric.add(plane); });
  const Vec3 lo = to_vec3(box.lo);
  const Vec3 hi = to_vec3(box.hi);
  if (position == VertexPosition::kProjection) return quadric.minimiser_projected(lo, hi);
  const auto is_knife = [&] {
    if (grid.sheet) return false;
    std::vector<const Plane*> planes;
    for_each_plane(grid, once, [&](const Plane& plane) { planes.push_back(&plane); });
    return some_face_away(planes);
  };
  const Minimiser least = minimiser_within(
      quadric, lo, hi, grid.tolerance,
      [&](const Vec3& x) { return distance_to_planes(grid, hits, x); }, is_knife);
  if (least.residual <= grid.tolerance) return least.point;
  std::vector<Plane> planes;
  for_each_plane(grid, hits, [&](const Plane& plane) { planes.push_back(plane); });
  return point_within(planes, centre, lo, hi, grid.tolerance).value_or(least.point);
}

double error_limit(const SplitError& error, const GridView& view, std::span<const Index> hits,
                   const Vec3& vertex) {
  double furthest = 0;
  for (const Index h : hits)
    furthest = std::max(furthest, (view.hit_points[h] - vertex).squaredNorm());
  return std::max(error.distance, error.of_hits * std::sqrt(furthest));
}

bool meets_planes(const GridData& grid, std::span<const Index> hits, const Vec3& vertex,
                  double distance) {
  return distance_to_planes(grid, hits, vertex) <= distance;
}

}  // namespace kdm
