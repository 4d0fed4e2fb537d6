// SPDX-License-Identifier: MIT
// Saved grids: they come back whole, and whatever is not one is refused.
#include "kdmanifold/grid_io.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "grid/validate.h"
#include "kdmanifold/build.h"
#include "kdmanifold/error.h"
#include "kdmanifold/extract.h"
#include "support/extract_any.h"
#include "support/grid_compare.h"
#include "support/random_meshes.h"
#include "support/shapes.h"

namespace kdm {
namespace {

using Bytes = std::vector<std::uint8_t>;
namespace fs = std::filesystem;

std::vector<Mesh> models() {
  return {shapes::cube(),
          shapes::rotated(shapes::cube(), Vec3(1, 2, 3), 1),
          shapes::inverted(shapes::icosphere(2)),
          shapes::rotated(shapes::torus(1, 0.4, 24, 12), Vec3(1, 2, 3), 1),
          shapes::rotated(shapes::thin_walled_box(0.02), Vec3(3, 1, 2), 1),
          shapes::overlapping_cubes(),
          shapes::integer_tetrahedra(9, 4, 1)};
}

TEST(GridIo, WhatIsSavedComesBack) {
  for (const Mesh& mesh : models()) {
    for (const BuildOptions& options :
         {BuildOptions{.relative_tolerance = 0.01},
          BuildOptions{.strategy = SplitStrategy::kOctree, .relative_tolerance = 0.01},
          BuildOptions{.strategy = SplitStrategy::kMedian, .depth = 15},
          BuildOptions{
              .strategy = SplitStrategy::kUniform, .depth = 9, .pairing = Pairing::kInside},
          BuildOptions{.strategy = SplitStrategy::kUniform, .depth = 1}}) {
      SCOPED_TRACE(mesh.triangles.size());
      SCOPED_TRACE(static_cast<int>(options.strategy));
      const Grid grid = build_grid(mesh, options);
      const Bytes bytes = save_grid(grid);
      EXPECT_EQ(save_grid(grid), bytes) << "the same grid gives the same bytes";
      EXPECT_LT(bytes.size(), grid.stats().bytes);
      const Grid loaded = load_grid(bytes);
      check::expect_same(grid, loaded);
      check::expect_same_surface(grid, loaded);
      EXPECT_EQ(save_grid(loaded), bytes);
      EXPECT_EQ(loaded.stats().bytes, grid.stats().bytes);
    }
  }
}

TEST(GridIo, AnEmptyGridIsSavedAsOneWithoutSplits) {
  const Grid loaded = load_grid(save_grid(Grid()));
  EXPECT_EQ(loaded.stats().cells, 1u);
  EXPECT_EQ(loaded.stats().hits, 0u);
  EXPECT_TRUE(check::extract_any(loaded).triangles.empty());
}

// Construction numbers splits depth first; a grid that does not is saved as well.
TEST(GridIo, SplitsMayBeNumberedInAnyOrder) {
  GridData grid;
  grid.cells.resize(9);
  constexpr std::int32_t kHalf = kLatticeSize / 2;
  grid.cells[0] = Cell(1, 0, kHalf);
  grid.cells[1] = Cell(5, 1, kHalf);
  grid.cells[2] = Cell(3, 2, kHalf + 17);
  grid.cells[3] = Cell(7, 0, kHalf + 1);
  grid.edge_begin.assign(17, 0);
  validate(grid);
  const Grid loaded = load_grid(save_grid(Grid(std::make_unique<GridData>(grid))));
  ASSERT_EQ(loaded.data().cells.size(), grid.cells.size());
  for (std::size_t c = 0; c < grid.cells.size(); ++c) {
    const Cell& cell = grid.cells[c];
    ASSERT_EQ(loaded.data().cells[c].leaf(), cell.leaf()) << c;
    if (cell.leaf()) continue;
    EXPECT_EQ(loaded.data().cells[c].below(), cell.below()) << c;
    EXPECT_EQ(loaded.data().cells[c].axis(), cell.axis()) << c;
    EXPECT_EQ(loaded.data().cells[c].value(), cell.value()) << c;
  }
}

TEST(GridIo, ReportsKeepTheirNumbers) {
  GridData grid =
      build_grid(shapes::cube(), {.strategy = SplitStrategy::kUniform, .depth = 3}).data();
  grid.input = {.vertices = kNone,
                .triangles = 2,
                .closed = true,
                .boundary_edges = 4,
                .non_manifold_edges = 5,
                .degenerate_faces = 6,
                .cancelled_faces = 7,
                .components = 8,
                .flipped = true,
                .lattice_step = grid.lattice.step};
  grid.stats.topology_resolved = true;
  grid.stats.unresolved_leaves = 9;
  grid.stats.guessed_faces = 300;
  for (const bool sheet : {false, true}) {
    grid.sheet = sheet;
    grid.input.boundary_loops = sheet ? 77 : 0;
    const Grid changed(std::make_unique<GridData>(grid));
    check::expect_same(changed, load_grid(save_grid(changed)));
  }
}

class GridFiles : public ::testing::Test {
 protected:
  GridFiles() : folder_(fs::path(::testing::TempDir()) / "kdmanifold-grid-files") {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  ~GridFiles() override { fs::remove_all(folder_); }
  std::string path(const char* name) const { return (folder_ / name).string(); }

  fs::path folder_;
};

TEST_F(GridFiles, WrittenAndReadAgain) {
  const Grid grid = build_grid(shapes::torus(), {.relative_tolerance = 0.01});
  write_grid(path("a.kdgrid"), grid);
  write_grid(path("B.KDGRID"), read_grid(path("a.kdgrid")));
  check::expect_same_surface(grid, read_grid(path("B.KDGRID")));
  EXPECT_EQ(fs::file_size(path("a.kdgrid")), save_grid(grid).size());
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()), 2);
}

TEST_F(GridFiles, ErrorsNameTheFile) {
  const auto expect_error = [](ErrorCode code, const std::string& text, const auto& call) {
    try {
      call();
      FAIL() << "no error: " << text;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), code) << error.what();
      EXPECT_NE(std::string(error.what()).find(text), std::string::npos) << error.what();
    }
  };
  const Grid grid;
  expect_error(ErrorCode::kIoError, "missing.kdgrid", [&] { read_grid(path("missing.kdgrid")); });
  expect_error(ErrorCode::kIoError, "a.obj", [&] { write_grid(path("a.obj"), grid); });
  expect_error(ErrorCode::kIoError, "no/a.kdgrid", [&] { write_grid(path("no/a.kdgrid"), grid); });
  std::ofstream(path("text.kdgrid")) << "kdgrid?";
  expect_error(ErrorCode::kParseError, "text.kdgrid: byte 0",
               [&] { read_grid(path("text.kdgrid")); });
}

TEST(GridIo, NamesOfGridsEndInKdgrid) {
  EXPECT_TRUE(names_a_grid("part.kdgrid"));
  EXPECT_TRUE(names_a_grid("a.b/PART.KdGrid"));
  EXPECT_FALSE(names_a_grid("part.kdgrid.obj"));
  EXPECT_FALSE(names_a_grid("kdgrid"));
  EXPECT_FALSE(names_a_grid(""));
}

}  // namespace
}  // namespace kdm
