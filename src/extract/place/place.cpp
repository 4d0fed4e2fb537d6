// SPDX-License-Identifier: MIT
// Where vertices go (paper 2.2.1).
#include "extract/place/place.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/quadric.h"

namespace kdm {
namespace {

// Calls `visit` for the planes that a vertex with these hits stands for: not those of invented hits
// where there are others, for the surface counts for more than what closes it.
template <typename Visit>
void for_each_plane(const GridData& grid, std::span<const Index> hits, const Visit& visit) {
  const bool all = grid.stats.invented_hits == 0 ||
                   std::all_of(hits.begin(), hits.end(), [&](Index h) { return grid.invented(h); });
  for (const Index h : hits) {
    if (all || !grid.invented(h)) visit(grid.plane_of(h));
  }
}

// The hits of a loop, but those of coincident edges once: how neighbours are split must not move a
// vertex away from where the split rule expects it.
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
  const Minimiser least = minimiser_within(quadric, lo, hi, grid.tolerance, [&](const Vec3& x) {
    return distance_to_planes(grid, hits, x);
  });
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

namespace {

// The rim at a half-edge on the boundary; null if it is not known.
const RimHit* rim_at(const GridData& grid, Index half_edge) {
  const Index hit = half_edge / 3;  // a triangle still has the number of its hit
  const Index wanted = 3 * hit + slot_at_place(half_edge % 3, grid.hits[hit].reversed());
  const auto rim =
      std::lower_bound(grid.rims.begin(), grid.rims.end(), wanted,
                       [](const RimHit& r, Index value) { return r.half_edge < value; });
  return rim != grid.rims.end() && rim->half_edge == wanted ? &*rim : nullptr;
}

// The rims that pass through the loop's links, its vertex being in its leaf on the rim's way.
void find_rims(const GridData& grid, const DualMesh& mesh, Index vertex,
               std::vector<const RimHit*>& rims) {
  rims.clear();
  if (grid.rims.empty()) return;
  const auto add = [&](Index half_edge) {
    if (half_edge == kNone) return;
    if (const RimHit* rim = rim_at(grid, half_edge)) rims.push_back(rim);
  };
  add(mesh.boundary_into(vertex));
  for (const HalfEdgeId h : mesh.ring(vertex)) {
    add(h);
    add(mesh.opposite[h]);
  }
}

// As far out as the surface goes: on the rim, between the points where it enters the leaf and
// leaves it; in its corner if it has one there.
Vec3 rim_position(const GridData& grid, std::span<const Index> hits,
                  std::span<const RimHit* const> rims, const LatticeBox& box) {
  Vec3 sum = Vec3::Zero();
  for (const RimHit* rim : rims) sum += rim->point;
  PrimalQuadric quadric(sum / static_cast<double>(rims.size()));
  for_each_plane(grid, hits, [&](const Plane& plane) { quadric.add(plane); });
  for (const RimHit* rim : rims) quadric.add({rim->normal, rim->normal.dot(rim->point)});
  return quadric.minimiser_in(to_vec3(box.lo), to_vec3(box.hi));
}

// Nearer to a corner than these fractions of the leaf's shortest side and of the tolerance, a
// vertex stays where its hits' planes meet.
constexpr double kBesideCorner = 0.05;
constexpr double kSlightly = 0.25;

bool beside(const Vec3& corner, const Vec3& point, const LatticeBox& box, double tolerance) {
  const double side = (to_vec3(box.hi) - to_vec3(box.lo)).minCoeff();
  return (corner - point).norm() <= std::max(kBesideCorner * side, kSlightly * tolerance);
}

}  // namespace

std::vector<std::pair<Index, Vec3>> kept_corners(const GridData& grid, const DualMesh& mesh) {
  std::vector<std::pair<Index, Vec3>> corners;
  for (const KeptCorner& corner : grid.corners) {
    const Index hit = corner.half_edge / 3;
    const Index place = place_of_slot(corner.half_edge % 3, grid.hits[hit].reversed());
    const Index vertex = mesh.vertex[3 * hit + place];
    if (vertex != kNone) corners.emplace_back(vertex, corner.point);  // else of a pillow
  }
  std::sort(corners.begin(), corners.end(),
            [](const auto& a, const auto& b) { return a.first < b.first; });
  return corners;
}

std::vector<Index> place_vertices(const GridView& view, const FaceSettings& settings,
                                  DualMesh& mesh) {
  const GridData& grid = view.grid;
  const auto vertices = mesh.vertices();
  mesh.position.reserve(vertices);
  std::vector<LoopId> missed;
  std::vector<Index> hits;
  std::vector<const RimHit*> rims;
  const std::vector<std::pair<Index, Vec3>> corners = kept_corners(grid, mesh);
  auto corner = corners.begin();
  for (Index vertex = 0; vertex < vertices; ++vertex) {
    hits.clear();
    for (const HalfEdgeId h : mesh.ring(vertex)) hits.push_back(mesh.hit[h / 3]);
    const LatticeBox& box = view.boxes[mesh.leaf[vertex]];
    find_rims(grid, mesh, vertex, rims);
    if (!rims.empty()) {
      mesh.position.push_back(rim_position(grid, hits, rims, box));
      continue;
    }
    while (corner != corners.end() && corner->first < vertex) ++corner;
    const Vec3 point = vertex_position(view, hits, box, settings.position);
    if (corner != corners.end() && corner->first == vertex &&
        !beside(corner->second, point, box, grid.tolerance)) {
      mesh.position.push_back(corner->second);
      continue;
    }
    mesh.position.push_back(point);
    if (!mesh.on_boundary(vertex) &&
        !meets_planes(grid, hits, point, settings.split_error.distance) &&
        !meets_planes(grid, hits, point, error_limit(settings.split_error, view, hits, point))) {
      missed.push_back(vertex);
    }
  }
  return missed;
}

}  // namespace kdm
