// SPDX-License-Identifier: MIT
// Places the vertices of loops: by planes, on rims and at corners.
#include "extract/place/place.h"

#include <algorithm>

#include "extract/place/vertex_position.h"
#include "geometry/quadric.h"
#include "mesh/sort.h"

namespace kdm {
namespace {

// Finds the rim at a half-edge on the boundary; returns null if the grid does not know it.
const RimHit* rim_at(const GridData& grid, Index half_edge) {
  const Index hit = half_edge / 3;  // a triangle still has the number of its hit
  const Index wanted = 3 * hit + slot_at_place(half_edge % 3, grid.hits[hit].reversed());
  const auto rim =
      std::lower_bound(grid.rims.begin(), grid.rims.end(), wanted,
                       [](const RimHit& r, Index value) { return r.half_edge < value; });
  return rim != grid.rims.end() && rim->half_edge == wanted ? &*rim : nullptr;
}

// Finds the points where the input's rim enters and leaves the leaf of the vertex: those of the
// half-edges on the boundary that start in it, end in it or lie opposite its ring.
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

// Returns the point of the box nearest to the hits' planes and to the planes through the rim, and
// so the furthest that the surface goes: between the points where the rim enters and leaves the
// leaf, or at a corner of the rim between them.
Vec3 rim_position(const GridData& grid, std::span<const Index> hits,
                  std::span<const RimHit* const> rims, const LatticeBox& box) {
  Vec3 sum = Vec3::Zero();
  for (const RimHit* rim : rims) sum += rim->point;
  PrimalQuadric quadric(sum / static_cast<double>(rims.size()));
  for_each_plane(grid, hits, [&](const Plane& plane) { quadric.add(plane); });
  for (const RimHit* rim : rims) quadric.add({rim->normal, rim->normal.dot(rim->point)});
  return quadric.minimiser_in(to_vec3(box.lo), to_vec3(box.hi));
}

// A vertex that is as near as this to the corner that the grid keeps in its leaf stays where its
// hits' planes meet: a fraction of the leaf's shortest side, but at least and at most these
// fractions of the tolerance.
constexpr double kCornerSideFraction = 0.05;
constexpr double kLeastCornerFraction = 0.25;
constexpr double kMostCornerFraction = 0.5;

bool is_beside(const Vec3& corner, const Vec3& point, const LatticeBox& box, double tolerance) {
  const double side = (to_vec3(box.hi) - to_vec3(box.lo)).minCoeff();
  return (corner - point).norm() <= std::clamp(kCornerSideFraction * side,
                                               kLeastCornerFraction * tolerance,
                                               kMostCornerFraction * tolerance);
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
  sort_by(corners, [](const auto& a, const auto& b) { return a.first < b.first; });
  return corners;
}

namespace {

// Notes in the mesh which vertices are joined.
void mark_joined(const GridData& grid, DualMesh& mesh) {
  if (grid.simplified == 0) return;
  mesh.joined.assign(mesh.vertices());
  for (const KeptCorner& corner : grid.corners) {
    const HitId hit = corner.half_edge / 3;
    const Index place = place_of_slot(corner.half_edge % 3, grid.hits[hit].reversed());
    const VertexId vertex = mesh.vertex[3 * hit + place];
    if (corner.joined && vertex != kNone) mesh.joined.set(vertex);
  }
}

}  // namespace

std::vector<Index> place_vertices(const GridView& view, const FaceSettings& settings,
                                  DualMesh& mesh) {
  const GridData& grid = view.grid;
  const auto vertices = mesh.vertices();
  mesh.position.reserve(vertices);
  mark_joined(grid, mesh);
  std::vector<LoopId> missed;
  std::vector<Index> hits;
  std::vector<const RimHit*> rims;
  const std::vector<std::pair<Index, Vec3>> corners = kept_corners(grid, mesh);
  auto corner = corners.begin();
  for (Index vertex = 0; vertex < vertices; ++vertex) {
    hits.clear();
    for (const HalfEdgeId h : mesh.ring(vertex)) hits.push_back(mesh.hit[h / 3]);
    const LatticeBox& box = view.boxes[mesh.leaf[vertex]];
    while (corner != corners.end() && corner->first < vertex) ++corner;
    const bool has_corner = corner != corners.end() && corner->first == vertex;
    if (has_corner && grid.simplified > 0) {
      mesh.position.push_back(corner->second);
      continue;
    }
    find_rims(grid, mesh, vertex, rims);
    if (!rims.empty()) {
      mesh.position.push_back(rim_position(grid, hits, rims, box));
      continue;
    }
    const Vec3 point = vertex_position(view, hits, box, settings.position);
    if (has_corner && !is_beside(corner->second, point, box, grid.tolerance)) {
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
