// SPDX-License-Identifier: MIT
// Where vertices go (paper 2.2.1).
#include "extract/place.h"

#include <algorithm>
#include <cmath>

#include "geometry/quadric.h"

namespace kdm {
std::vector<Vec3> hit_points(const GridData& grid, const std::vector<LatticeBox>& boxes) {
  std::vector<Vec3> points(grid.hits.size());
  for (std::size_t c = 0; c < grid.cells.size(); ++c) {
    const Cell& cell = grid.cells[c];
    if (cell.leaf()) continue;
    const int u = next_axis(cell.axis());
    const int v = previous_axis(cell.axis());
    for (int i = 0; i < 4; ++i) {
      const Index edge = 4 * cell.split() + static_cast<Index>(i);
      Vec3 point;
      point[cell.axis()] = cell.value();
      point[u] = i == 1 ? boxes[c].hi[u] : boxes[c].lo[u];
      point[v] = i == 2 ? boxes[c].hi[v] : boxes[c].lo[v];
      for (Index h = grid.edge_begin[edge]; h < grid.edge_begin[edge + 1]; ++h) {
        point[axis_of_edge(cell.axis(), i)] = real_position(grid.hits[h].position);
        points[h] = point;
      }
    }
  }
  return points;
}

namespace {

// The largest distance to the planes of the hits.
double residual(const GridData& grid, std::span<const Index> hits, const Vec3& vertex) {
  double largest = 0;
  for (const Index h : hits) {
    const Plane& plane = grid.planes[grid.hits[h].plane()];
    largest = std::max(largest, std::abs(plane.normal.dot(vertex) - plane.offset));
  }
  return largest;
}

}  // namespace

Vec3 vertex_position(const GridData& grid, const std::vector<Vec3>& points,
                     std::span<const Index> hits, const LatticeBox& box, VertexPosition position) {
  Vec3 sum = Vec3::Zero();
  for (const Index h : hits) sum += points[h];
  PrimalQuadric quadric(sum / static_cast<double>(hits.size()));
  for (const Index h : hits) quadric.add(grid.planes[grid.hits[h].plane()]);
  const Vec3 lo = real(box.lo);
  const Vec3 hi = real(box.hi);
  if (position == VertexPosition::kProjection) return quadric.minimiser_projected(lo, hi);
  return minimiser_within(quadric, lo, hi, grid.tolerance,
                          [&](const Vec3& x) { return residual(grid, hits, x); });
}

double error_limit(const SplitError& error, const std::vector<Vec3>& points,
                   std::span<const Index> hits, const Vec3& vertex) {
  double furthest = 0;
  for (const Index h : hits) furthest = std::max(furthest, (points[h] - vertex).squaredNorm());
  return std::max(error.distance, error.of_hits * std::sqrt(furthest));
}

bool meets_planes(const GridData& grid, std::span<const Index> hits, const Vec3& vertex,
                  double distance) {
  return std::all_of(hits.begin(), hits.end(), [&](Index h) {
    const Plane& plane = grid.planes[grid.hits[h].plane()];
    return std::abs(plane.normal.dot(vertex) - plane.offset) <= distance;
  });
}

std::vector<Index> place_vertices(const GridData& grid, const std::vector<LatticeBox>& boxes,
                                  const std::vector<Vec3>& points, const SplitError& error,
                                  VertexPosition position, DualMesh& mesh) {
  const auto vertices = static_cast<Index>(mesh.first.size());
  mesh.position.reserve(vertices);
  std::vector<Index> off;
  std::vector<Index> hits;
  for (Index vertex = 0; vertex < vertices; ++vertex) {
    hits.clear();
    const Index first = mesh.first[vertex];
    Index half_edge = first;
    do {
      hits.push_back(mesh.hit[half_edge / 3]);
      half_edge = next_in_triangle(mesh.opposite[half_edge]);
    } while (half_edge != first);
    const Vec3 point = vertex_position(grid, points, hits, boxes[mesh.leaf[vertex]], position);
    mesh.position.push_back(point);
    if (!meets_planes(grid, hits, point, error.distance) &&
        !meets_planes(grid, hits, point, error_limit(error, points, hits, point))) {
      off.push_back(vertex);
    }
  }
  return off;
}

}  // namespace kdm
