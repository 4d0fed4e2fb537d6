// SPDX-License-Identifier: MIT
// Takes a grid's surface for simplification, and gives the grid back.
#include "simplify/work_grid.h"

#include <algorithm>

#include "extract/dual/dual_mesh.h"
#include "extract/mend/slivers.h"
#include "extract/place/place.h"
#include "grid/splitting_edges.h"

namespace kdm {
namespace {

// The disk that a hit stands for at first: half as wide as its triangle.
DualQuadric disk_of(const WorkGrid& work, HitId hit, const Vec3& point) {
  double sum = 0;
  for (const Vec3& corner : work.corners(hit)) sum += (corner - point).norm();
  return {point, work.grid.plane_of(hit).normal, sum / 6};
}

}  // namespace

WorkGrid::WorkGrid(const GridData& data)
    : grid(data),
      merged_cells(data.cells.size()),
      boxes(cell_boxes(data)),
      parent(data.cells.size(), kNone),
      cell_of_split(cells_of_splits(data)),
      split_of_hit(data.hits.size()),
      relinked(data.opposite.size()) {
  for (CellId c = 0; c < grid.cells.size(); ++c) {
    if (!grid.cells[c].leaf()) parent[grid.cells[c].below()] = parent[grid.cells[c].above()] = c;
  }
  for (SplitId k = 0; k < grid.splits(); ++k) {
    for (HitId h = grid.edge_begin[4 * k]; h < grid.edge_begin[4 * k + 4]; ++h) split_of_hit[h] = k;
  }
  const std::vector<Vec3> hit_at = hit_points(grid, boxes);
  const GridView view{grid, boxes, hit_at};
  DualMesh mesh = dual_mesh_of(grid);
  find_loops(grid, mesh);
  const std::vector<LoopId> missed =
      place_vertices(view, {.split_error = standard_split_error(grid)}, mesh);
  loop.resize(grid.opposite.size());
  for (HalfEdgeId h = 0; h < loop.size(); ++h) {
    loop[h] = mesh.vertex[h - h % 3 + place_of_slot(h % 3, grid.hits[h / 3].reversed())];
  }
  leaf = mesh.leaf;
  const std::vector<Vec3> placed = mesh.position;
  if (grid.simplified == 0) move_off_slivers(view, mesh);
  position = mesh.position;
  ring_changed.assign(position.size());
  joined.assign(position.size());
  split.assign(position.size());
  for (LoopId v = 0; v < position.size(); ++v) {
    if (position[v] != placed[v]) ring_changed.set(v);
    if (mesh.keeps_edges(v)) joined.set(v);
  }
  for (const LoopId v : missed) split.set(v);
  planes.reserve(position.size());
  for (const Vec3& p : position) planes.emplace_back(p);
  for (HalfEdgeId h = 0; h < loop.size(); ++h) planes[loop[h]].add(grid.plane_of(h / 3));
  points.reserve(grid.hits.size());
  for (HitId h = 0; h < grid.hits.size(); ++h) points.push_back(disk_of(*this, h, hit_at[h]));
  // From now on these vertices stay where they are, whatever the rules for corners say.
  for (const KeptCorner& corner : grid.corners) ring_changed.set(loop[corner.half_edge], true);
}

GridData WorkGrid::result(double moved) const {
  GridData out = grid;
  DisjointSets merged = merged_cells;
  out.corners.clear();
  Marks seen(position.size());
  for (SplitId k = 0; k < cell_of_split.size(); ++k) {
    if (grid.cells[cell_of_split[k]].leaf()) continue;
    for (HalfEdgeId h = 3 * grid.edge_begin[4 * k]; h < 3 * grid.edge_begin[4 * k + 4]; ++h) {
      const LoopId v = loop[h];
      if (seen.test_and_set(v)) continue;
      if (ring_changed.test(v) || merged.find(leaf[v]) != leaf[v]) {
        out.corners.push_back({h, position[v], joined.test(v)});
      }
    }
  }
  if (!out.sheet) {
    std::erase_if(out.rims, [&](const RimHit& rim) { return relinked.test(rim.half_edge); });
  }
  out.simplified += moved;
  compact(out, merged);
  return out;
}

}  // namespace kdm
