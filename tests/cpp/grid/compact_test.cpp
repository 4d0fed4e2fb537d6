// SPDX-License-Identifier: MIT
#include "grid/compact.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <vector>

#include "grid/links.h"
#include "grid/splitting_edges.h"
#include "grid/validate.h"
#include "kdmanifold/build.h"
#include "kdmanifold/extract.h"
#include "kdmanifold/grid_io.h"
#include "support/grid_compare.h"
#include "support/mesh_assert.h"
#include "support/shapes.h"
#include "support/sheets.h"

namespace kdm {
namespace {

std::vector<std::uint8_t> saved(const GridData& grid) {
  return save_grid(Grid(std::make_unique<GridData>(grid)));
}

struct Case {
  const char* name;
  Mesh mesh;
  BuildOptions options;
};

// Solids, soups that are repaired, and sheets; with strips, rims, corners and invented hits.
std::vector<Case> cases() {
  const Mesh torus = shapes::rotated(shapes::torus(1, 0.3, 48, 24), Vec3(1, 2, 3), 1);
  const Mesh cube = shapes::rotated(shapes::cube(), Vec3(1, 1, 0.3), 0.7);
  const Mesh open = shapes::open(shapes::icosphere(3), 40);
  return {{"torus", torus, {.relative_tolerance = 0.004}},
          {"uniform torus", torus, {.strategy = SplitStrategy::kUniform, .depth = 12}},
          {"octree ball", shapes::icosphere(4), {.strategy = SplitStrategy::kOctree, .depth = 14}},
          {"cube", cube, {.relative_tolerance = 0.02}},
          {"cubes", shapes::overlapping_cubes(), {.relative_tolerance = 0.01}},
          {"glass", shapes::glass(), {.relative_tolerance = 0.02}},
          {"repaired", open, {.relative_tolerance = 0.01}},
          {"sheet", open, {.relative_tolerance = 0.01, .inside = InsideRule::kSheet}},
          {"square",
           shapes::grid_sheet(9, 9, [](double x, double y) { return 0.3 * x * y; }),
           {.strategy = SplitStrategy::kUniform, .depth = 12, .inside = InsideRule::kSheet}}};
}

TEST(Compact, ChangesNothingOfABuiltGrid) {
  for (const Case& c : cases()) {
    SCOPED_TRACE(c.name);
    const Grid built = build_grid(c.mesh, c.options);
    auto compacted = std::make_unique<GridData>(built.data());
    compact(*compacted);
    EXPECT_EQ(saved(*compacted), save_grid(built));
    check::expect_same(Grid(std::move(compacted)), built);
  }
}

bool edges_are_empty(const GridData& grid, SplitId split) {
  for (int i = 0; i < 4; ++i) {
    if (!grid.edge_hits(split, i).empty()) return false;
  }
  return true;
}

// Removes all splits without hits between leaves, then those that become such. No link passes
// through the face between the two leaves, for its sides have no hits.
Index remove_empty_splits(GridData& grid, DisjointSets& merged_cells) {
  Index removed = 0;
  for (CellId c = static_cast<CellId>(grid.cells.size()); c-- > 0;) {  // children first
    const Cell& cell = grid.cells[c];
    if (cell.leaf() || !grid.cells[cell.below()].leaf() || !grid.cells[cell.above()].leaf() ||
        !edges_are_empty(grid, cell.split())) {
      continue;
    }
    remove_split(grid, c, merged_cells);
    ++removed;
  }
  return removed;
}

TEST(Compact, NumbersAGridWithoutItsEmptySplits) {
  Index removed = 0;
  for (const Case& c : cases()) {
    SCOPED_TRACE(c.name);
    const GridData built = build_grid(c.mesh, c.options).data();
    GridData grid = built;
    DisjointSets merged_cells(grid.cells.size());
    const Index here = remove_empty_splits(grid, merged_cells);
    removed += here;
    compact(grid, merged_cells);
    ASSERT_NO_THROW(validate(grid));
    EXPECT_EQ(grid.splits(), built.splits() - here);
    EXPECT_EQ(grid.stats.leaves, built.stats.leaves - here);
    EXPECT_EQ(grid.stats.cells, grid.cells.size());
    EXPECT_EQ(grid.hits.size(), built.hits.size());
    EXPECT_EQ(grid.rims.size(), built.rims.size());
    EXPECT_EQ(grid.corners.size(), built.corners.size());
    EXPECT_EQ(grid.planes.size(), built.planes.size());
    // All hits are there, in the old order and with the old links.
    EXPECT_EQ(grid.opposite, built.opposite);
    for (HitId h = 0; h < grid.hits.size(); ++h) {
      ASSERT_EQ(grid.hits[h].position, built.hits[h].position);
      ASSERT_EQ(grid.hits[h].packed, built.hits[h].packed);
    }
    const Grid compacted(std::make_unique<GridData>(grid));
    const ExtractedMesh out = extract(compacted);
    if (grid.sheet) {
      EXPECT_TRUE(check::is_manifold(out));
    } else {
      EXPECT_TRUE(check::is_two_manifold(out));
    }
    check::expect_same(load_grid(save_grid(compacted)), compacted);
  }
  EXPECT_GT(removed, 100u);
}

// What was compacted is compact.
TEST(Compact, TwiceIsOnce) {
  GridData grid =
      build_grid(shapes::icosphere(4), {.strategy = SplitStrategy::kUniform, .depth = 12}).data();
  DisjointSets merged_cells(grid.cells.size());
  ASSERT_GT(remove_empty_splits(grid, merged_cells), 0u);
  compact(grid, merged_cells);
  const std::vector<std::uint8_t> once = saved(grid);
  compact(grid);
  EXPECT_EQ(saved(grid), once);
}

TEST(Compact, NumbersPlanesByTheirFirstHits) {
  const GridData built =
      build_grid(shapes::overlapping_cubes(), {.relative_tolerance = 0.01}).data();
  GridData grid = built;
  const auto planes = static_cast<PlaneId>(grid.planes.size());
  // Planes the other way round behind one that nobody needs, and another one behind them.
  const Plane unused{Vec3::UnitX(), 7};
  grid.planes = {unused};
  grid.source_faces = {12345};
  for (PlaneId p = planes; p-- > 0;) {
    grid.planes.push_back(built.planes[p]);
    grid.source_faces.push_back(built.source_faces[p]);
  }
  grid.planes.push_back(unused);
  grid.source_faces.push_back(kNone);
  for (Hit& hit : grid.hits) {
    hit = Hit(hit.position, planes - hit.plane(), hit.leaving(), hit.reversed());
  }
  compact(grid);
  EXPECT_EQ(saved(grid), saved(built));
  check::expect_same(Grid(std::make_unique<GridData>(grid)),
                     Grid(std::make_unique<GridData>(built)));
}

// The simplest removal of hits: a sheet's, whose half-edges may lose their partners.
TEST(Compact, DropsTheHitsOfRemovedSplitsWithTheirRimsAndPlanes) {
  GridData grid = build_grid(shapes::open(shapes::icosphere(3), 40),
                             {.relative_tolerance = 0.01, .inside = InsideRule::kSheet})
                      .data();
  const std::size_t hits_before = grid.hits.size();
  const std::size_t rims_before = grid.rims.size();
  ASSERT_GT(rims_before, 0u);
  DisjointSets merged_cells(grid.cells.size());
  const std::vector<CellId> cell_of = cells_of_splits(grid);
  std::size_t dropped_hits = 0;
  std::size_t dropped_rims = 0;
  // Half of the splits, from the last one on: what they leave is no valid grid, but one of which
  // everything has a number.
  for (SplitId k = grid.splits(); k-- > 0;) {
    const Cell cell = grid.cells[cell_of[k]];
    if (k % 2 == 1 || !grid.cells[cell.below()].leaf() || !grid.cells[cell.above()].leaf())
      continue;
    for (int i = 0; i < 4; ++i) {
      for (const HitId h : grid.edge_hits(k, i)) {
        ++dropped_hits;
        for (HalfEdgeId half_edge = 3 * h; half_edge < 3 * h + 3; ++half_edge) {
          unlink(grid, half_edge);
          dropped_rims += static_cast<std::size_t>(
              std::count_if(grid.rims.begin(), grid.rims.end(),
                            [&](const RimHit& rim) { return rim.half_edge == half_edge; }));
        }
      }
    }
    remove_split(grid, cell_of[k], merged_cells);
  }
  ASSERT_GT(dropped_hits, 0u);
  ASSERT_GT(dropped_rims, 0u);
  compact(grid, merged_cells);
  EXPECT_EQ(grid.hits.size(), hits_before - dropped_hits);
  EXPECT_EQ(grid.rims.size(), rims_before - dropped_rims);
  EXPECT_EQ(grid.edge_begin.size(), 4 * grid.splits() + 1);
  EXPECT_EQ(grid.edge_begin.back(), grid.hits.size());
  EXPECT_TRUE(
      std::is_sorted(grid.rims.begin(), grid.rims.end(),
                     [](const RimHit& a, const RimHit& b) { return a.half_edge < b.half_edge; }));
  PlaneId met = 0;
  for (const Hit& hit : grid.hits) {
    ASSERT_LE(hit.plane(), met);
    if (hit.plane() == met) ++met;
  }
  EXPECT_EQ(met, grid.planes.size());
  for (HalfEdgeId h = 0; h < grid.opposite.size(); ++h) {
    ASSERT_TRUE(grid.cells[grid.start_leaf(h)].leaf());
    if (grid.opposite[h] == kNone) continue;
    ASSERT_LT(grid.opposite[h], grid.opposite.size());
    ASSERT_EQ(grid.opposite[grid.opposite[h]], h);
  }
}

}  // namespace
}  // namespace kdm
