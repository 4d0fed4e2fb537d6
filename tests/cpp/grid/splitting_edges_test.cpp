// SPDX-License-Identifier: MIT
#include "grid/splitting_edges.h"

#include <gtest/gtest.h>

#include <fstream>
#include <string>
#include <vector>

#include "kdmanifold/build.h"
#include "support/paths.h"
#include "support/shapes.h"

namespace kdm {
namespace {

GridData torus_grid() {
  return build_grid(shapes::torus(1, 0.4, 24, 12), {.strategy = SplitStrategy::kOctree, .depth = 9})
      .data();
}

TEST(SplittingEdges, AreVisitedInTheOrderOfTheirNumbersWithAllHits) {
  const GridData grid = torus_grid();
  ASSERT_GT(grid.hits.size(), 100u);
  EdgeId edges = 0;
  HitId hits = 0;
  for_each_splitting_edge(grid, cell_boxes(grid), [&](const SplittingEdge& edge) {
    EXPECT_EQ(edge.number, edges++);
    EXPECT_EQ(edge.number, edge_of_split(grid.cells[edge.cell].split(), edge.i));
    EXPECT_EQ(&edge.split, &grid.cells[edge.cell]);
    EXPECT_EQ(edge.hits.size(), grid.edge_hits(edge.number).size());
    for (const HitId h : edge.hits) EXPECT_EQ(h, hits++);
  });
  EXPECT_EQ(edges, 4 * grid.splits());
  EXPECT_EQ(hits, grid.hits.size());
}

// As in the drawing in grid_data.h.
TEST(SplittingEdges, GoRoundTheirFace) {
  const GridData grid = torus_grid();
  for_each_splitting_edge(grid, cell_boxes(grid), [&](const SplittingEdge& edge) {
    const int w = edge.split.axis();
    const int u = next_axis(w);
    const int v = previous_axis(w);
    const LatticeBox& box = edge.box;
    LatticePoint low;
    LatticePoint high;
    low[w] = high[w] = edge.split.value();
    low[u] = edge.i == 1 ? box.hi[u] : box.lo[u];
    high[u] = edge.i == 3 ? box.lo[u] : box.hi[u];
    low[v] = edge.i == 2 ? box.hi[v] : box.lo[v];
    high[v] = edge.i == 0 ? box.lo[v] : box.hi[v];
    ASSERT_EQ(edge.low(), low);
    ASSERT_EQ(edge.high(), high);
    ASSERT_EQ(edge.axis, edge.i % 2 == 0 ? u : v);
    const bool across_u = edge.axis == v;
    ASSERT_EQ(edge_on_side(w, across_u ? u : v, edge.i == 1 || edge.i == 2), edge.i);
  });
}

TEST(SplittingEdges, OfRemovedSplitsAreLeftOut) {
  GridData grid = torus_grid();
  CellId last = 0;  // a cell whose children are leaves
  for (CellId c = 0; c < grid.cells.size(); ++c) {
    if (!grid.cells[c].leaf()) last = c;
  }
  const SplitId removed = grid.cells[last].split();
  grid.cells[last] = Cell();
  EXPECT_EQ(cells_of_splits(grid)[removed], kNone);
  EdgeId edges = 0;
  for_each_splitting_edge(grid, cell_boxes(grid), [&](const SplittingEdge& edge) {
    EXPECT_NE(edge.number / 4, removed);
    ++edges;
  });
  EXPECT_EQ(edges, 4 * (grid.splits() - 1));
}

TEST(SplittingEdges, ARangeOfHitsYieldsItsNumbers) {
  std::vector<HitId> hits;
  for (const HitId h : HitRange{3, 6}) hits.push_back(h);
  EXPECT_EQ(hits, (std::vector<HitId>{3, 4, 5}));
  EXPECT_EQ((HitRange{3, 6}).size(), 3u);
  EXPECT_TRUE((HitRange{6, 6}).empty());
}

// A formatter that flows comments anew takes the drawing for sentences.
TEST(GridDrawing, KeepsItsLines) {
  std::ifstream header(paths::kRoot / "src/grid/grid_data.h");
  std::vector<std::string> lines;
  bool drawing = false;
  for (std::string line; std::getline(header, line);) {
    if (line == "// clang-format on") drawing = false;
    if (drawing && line != "//") lines.push_back(line);
    if (line == "// clang-format off") drawing = true;
  }
  ASSERT_EQ(lines.size(), 8u);
  const std::size_t left = lines[1].find('+');
  const std::size_t right = lines[1].rfind('+');
  ASSERT_LT(left, right);
  EXPECT_NE(lines[0].find("2 (top)"), std::string::npos);
  for (std::size_t i = 1; i <= 5; ++i) {
    ASSERT_GT(lines[i].size(), right) << lines[i];
    EXPECT_EQ(lines[i][left], lines[1][left] == lines[i][left] ? '+' : '|') << lines[i];
    EXPECT_EQ(lines[i][right], lines[i][left]) << lines[i];
  }
  EXPECT_EQ(lines[5].find("+--"), left);
  EXPECT_LT(lines[3].find("3 (left)"), left);
  EXPECT_GT(lines[3].find("1 (right)"), right);
  EXPECT_NE(lines[6].find("0 (bottom)"), std::string::npos);
  EXPECT_NE(lines[7].find("> u"), std::string::npos);
}

}  // namespace
}  // namespace kdm
