// SPDX-License-Identifier: MIT
// Saved grids of sheets: what is missing or crosses comes back as well.
#include <gtest/gtest.h>

#include <algorithm>

#include "grid/saved/sheet_links.h"
#include "grid/validate.h"
#include "kdmanifold/build.h"
#include "kdmanifold/grid_io.h"
#include "support/grid_compare.h"
#include "support/random.h"
#include "support/random_meshes.h"
#include "support/sheets.h"

namespace kdm {
namespace {

// Three faces on an edge, two of them one way.
Mesh three_pages() {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {0, 0, 1}, {1, 0.1, 0.4}, {-0.7, 0.6, 0.5}, {-0.5, -0.9, 0.6}};
  mesh.triangles = {{0, 1, 2}, {0, 1, 3}, {1, 0, 4}};
  return mesh;
}

// Faces missing, turned over and doubled.
Mesh torn_soup(std::uint32_t seed) {
  check::Random random(seed);
  Mesh mesh = shapes::random_tetrahedra(10, seed);
  std::vector<Triangle> triangles;
  for (Triangle t : mesh.triangles) {
    if (random.below(4) == 0) continue;
    if (random.below(5) == 0) std::swap(t[0], t[1]);
    triangles.push_back(t);
    if (random.below(6) == 0) triangles.push_back(t);
  }
  mesh.triangles = triangles;
  return mesh;
}

void expect_saved(const Mesh& mesh, const BuildOptions& options) {
  const Grid grid = build_grid(mesh, options);
  const std::vector<std::uint8_t> bytes = save_grid(grid);
  const Grid loaded = load_grid(bytes);
  ASSERT_NO_THROW(validate(loaded.data()));
  check::expect_same(grid, loaded);
  check::expect_same_surface(grid, loaded);
  EXPECT_EQ(save_grid(loaded), bytes);
  EXPECT_EQ(loaded.stats().bytes, grid.stats().bytes);
}

std::vector<BuildOptions> all_options() {
  return {{.relative_tolerance = 0.01, .inside = InsideRule::kSheet},
          {.strategy = SplitStrategy::kOctree,
           .relative_tolerance = 0.01,
           .inside = InsideRule::kSheet},
          {.strategy = SplitStrategy::kMedian, .depth = 12, .inside = InsideRule::kSheet},
          {.strategy = SplitStrategy::kUniform,
           .depth = 6,
           .inside = InsideRule::kSheet,
           .pairing = Pairing::kHermite}};
}

class SavedSheets : public testing::TestWithParam<shapes::OpenShape> {};

TEST_P(SavedSheets, ComeBack) {
  for (const BuildOptions& options : all_options()) expect_saved(GetParam().mesh, options);
}

INSTANTIATE_TEST_SUITE_P(SheetIo, SavedSheets, testing::ValuesIn(shapes::open_shapes()),
                         [](const auto& shape) { return shape.param.name; });

TEST(SheetIo, WhatCannotBeOrientedComesBack) {
  for (const BuildOptions& options : all_options()) {
    expect_saved(shapes::moebius_band(24), options);
    expect_saved(three_pages(), options);
    for (std::uint32_t seed = 0; seed < 5; ++seed) expect_saved(torn_soup(seed), options);
  }
}

// Walls without thickness have hits of both directions at one position.
TEST(SheetIo, TwoSidedWallsComeBack) {
  const Mesh square = shapes::grid_sheet(3, 3, [](double x, double y) { return 0.3 * x * y; });
  const Mesh wall = shapes::merged({square, shapes::inverted(square)});
  const Grid grid = build_grid(wall, {.relative_tolerance = 0.01, .inside = InsideRule::kSheet});
  const std::vector<Hit>& hits = grid.data().hits;
  const auto equal = [](const Hit& a, const Hit& b) { return a.position == b.position; };
  EXPECT_NE(std::adjacent_find(hits.begin(), hits.end(), equal), hits.end());
  for (const BuildOptions& options : all_options()) expect_saved(wall, options);
}

// Every way to link hits round a face, missing and crossing links included.
TEST(SheetIo, AllLinksOfAFaceCanBeTold) {
  SheetLinkDecisions decide;
  int links_told = 0;
  constexpr Index kHits = 6;
  for (unsigned pattern = 0; pattern < 1u << kHits; ++pattern) {
    Marks starts_below;
    for (Index i = 0; i < kHits; ++i) starts_below.push_back((pattern >> i & 1u) != 0);
    std::vector<Index> partner(kHits, kNone);
    const auto try_all = [&](auto&& self, Index i) -> void {
      if (i == kHits) {
        std::vector<bool> bits;
        const auto note = [&](bool bit) {
          bits.push_back(bit);
          return bit;
        };
        decide(
            starts_below, [&](Index a) { return note(partner[a] != kNone); },
            [&](Index a, Index b) { return note(partner[a] == b); }, [](Index, Index) {});
        std::vector<Index> told(kHits, kNone);
        std::size_t read = 0;
        decide(
            starts_below, [&](Index) { return bits[read++]; },
            [&](Index, Index) { return bits[read++]; },
            [&](Index a, Index b) {
              told[a] = b;
              told[b] = a;
            });
        ASSERT_EQ(told, partner);
        ASSERT_EQ(read, bits.size());
        ++links_told;
        return;
      }
      self(self, i + 1);
      if (partner[i] != kNone) return;
      for (Index j = i + 1; j < kHits; ++j) {
        if (partner[j] != kNone || starts_below.test(i) == starts_below.test(j)) continue;
        partner[i] = j;
        partner[j] = i;
        self(self, i + 1);
        partner[i] = partner[j] = kNone;
      }
    };
    try_all(try_all, 0);
  }
  EXPECT_GT(links_told, 64);
}

}  // namespace
}  // namespace kdm
