// SPDX-License-Identifier: MIT
// Counts the statistics that follow from the grid alone.
#include "grid/count_stats.h"

#include <algorithm>

#include "grid/faces.h"

namespace kdm {
namespace {

int depth_of(const GridData& grid) {
  int deepest = 0;
  std::vector<std::uint8_t> depth(grid.cells.size(), 0);
  for (CellId c = 0; c < grid.cells.size(); ++c) {  // children follow their cell
    const Cell& cell = grid.cells[c];
    deepest = std::max<int>(deepest, depth[c]);
    if (cell.leaf()) continue;
    depth[cell.below()] = depth[cell.above()] = static_cast<std::uint8_t>(depth[c] + 1);
  }
  return deepest;
}

}  // namespace

void count_stats(GridData& grid) {
  grid.stats.cells = static_cast<Index>(grid.cells.size());
  grid.stats.leaves = static_cast<Index>(grid.cells.size() - grid.splits());
  grid.stats.depth = depth_of(grid);
  grid.stats.hits = static_cast<Index>(grid.hits.size());
  grid.stats.invented_hits = 0;
  for (HitId h = 0; h < grid.hits.size(); ++h) {
    const Index source = grid.source_faces[grid.hits[h].plane()];
    if (source == kNone || source == kPatch) ++grid.stats.invented_hits;
  }
  grid.stats.tolerance = grid.tolerance * grid.lattice.step;
  grid.stats.simplified = grid.simplified;
  grid.stats.exact_triangles = static_cast<Index>(grid.exact.triangles.size());
  grid.stats.sheet = grid.sheet;
  grid.stats.bytes = grid.bytes();
}

Index count_ambiguous_faces(const GridData& grid) {
  Index count = 0;
  for_each_face(grid, cell_boxes(grid), [&](const MinimalFace& face) {
    if (is_ambiguous(face)) ++count;
  });
  return count;
}

}  // namespace kdm
