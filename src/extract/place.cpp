// SPDX-License-Identifier: MIT
// Where vertices go (paper 2.2.1).
#include "extract/place.h"

#include "geometry/quadric.h"

namespace kdm {
namespace {

Vec3 real(const LatticePoint& p) { return Vec3(p[0], p[1], p[2]); }

}  // namespace

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

Vec3 vertex_position(const GridData& grid, const std::vector<Vec3>& points,
                     std::span<const Index> hits, const LatticeBox& box) {
  Vec3 sum = Vec3::Zero();
  for (const Index h : hits) sum += points[h];
  PrimalQuadric quadric(sum / static_cast<double>(hits.size()));
  for (const Index h : hits) quadric.add(grid.planes[grid.hits[h].plane()]);
  return quadric.minimiser_in(real(box.lo), real(box.hi));
}

void place_vertices(const GridData& grid, const std::vector<LatticeBox>& boxes,
                    const std::vector<Vec3>& points, DualMesh& mesh) {
  mesh.position.reserve(mesh.first.size());
  std::vector<Index> hits;
  for (std::size_t vertex = 0; vertex < mesh.first.size(); ++vertex) {
    hits.clear();
    const Index first = mesh.first[vertex];
    Index half_edge = first;
    do {
      hits.push_back(mesh.hit[half_edge / 3]);
      half_edge = next_in_triangle(mesh.opposite[half_edge]);
    } while (half_edge != first);
    mesh.position.push_back(vertex_position(grid, points, hits, boxes[mesh.leaf[vertex]]));
  }
}

}  // namespace kdm
