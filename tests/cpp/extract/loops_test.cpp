// SPDX-License-Identifier: MIT
// From links to loops, and the parts without volume that are left out.
#include <gtest/gtest.h>

#include "grid/pillows.h"

#include <algorithm>
#include <set>

#include "extract/dual/dual_mesh.h"
#include "kdmanifold/build.h"
#include "kdmanifold/extract.h"
#include "support/dual_mesh_shapes.h"
#include "support/extract_any.h"
#include "support/mesh_assert.h"
#include "support/shapes.h"

namespace kdm {
namespace {

using shapes::dual_mesh;

const std::vector<Triangle> kTetrahedron{{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}};

Index kept_triangles(const DualMesh& mesh) {
  Index kept = 0;
  for (Index t = 0; t < mesh.triangles(); ++t) kept += mesh.dropped(t) ? 0 : 1;
  return kept;
}

// Numbers of the second part come after those of the first.
std::vector<Triangle> beside(std::vector<Triangle> first, const std::vector<Triangle>& second,
                             Index offset) {
  for (const auto& [a, b, c] : second) first.push_back({a + offset, b + offset, c + offset});
  return first;
}

// --- Pillows -------------------------------------------------------------------------------------

const std::vector<Triangle> kPillow{{0, 1, 2}, {0, 2, 1}};

// Two quads back to back, each cut along a strip: 0-1 in front, 0-1 behind.
//
//     3---1        front {0, 1, 3} {1, 0, 2}, behind the same turned round
//     | / |
//     0---2
DualMesh quad_pillow(Index offset = 0) {
  std::vector<Triangle> triangles =
      beside({}, {{0, 1, 3}, {1, 0, 2}, {1, 0, 3}, {0, 1, 2}}, offset);
  DualMesh mesh = dual_mesh(triangles, {{0, 3},     // the diagonal in front
                                        {6, 9},     // and behind
                                        {1, 8},     // 1-3 and 3-1
                                        {2, 7},     // 3-0 and 0-3
                                        {4, 11},    // 0-2 and 2-0
                                        {5, 10}});  // 2-1 and 1-2
  mesh.strip = {1, 1, 1, 1};
  return mesh;
}

TEST(Pillows, TwoTrianglesBackToBackAreDropped) {
  DualMesh mesh = dual_mesh(kPillow);
  EXPECT_EQ(drop_pillows(mesh), 1u);
  EXPECT_TRUE(mesh.dropped(0));
  EXPECT_TRUE(mesh.dropped(1));
}

TEST(Pillows, TwoQuadsBackToBackAreDropped) {
  DualMesh mesh = quad_pillow();
  EXPECT_EQ(drop_pillows(mesh), 1u);
  EXPECT_EQ(kept_triangles(mesh), 0u);
}

TEST(Pillows, AGridTellsWhetherItHasSome) {
  GridData grid;
  grid.opposite = {3, 4, 5, 0, 1, 2};
  grid.start.assign(6, 0);
  EXPECT_TRUE(has_pillows(grid));
  grid.opposite = dual_mesh(kTetrahedron).opposite;
  grid.start.assign(12, 0);
  EXPECT_FALSE(has_pillows(grid));
  const DualMesh quads = quad_pillow();
  grid.opposite = quads.opposite;
  grid.start = std::vector<std::uint32_t>(12, 0);
  for (const HalfEdgeId h : {0, 3, 6, 9}) grid.start[h] = GridData::kStrip;
  EXPECT_TRUE(has_pillows(grid));
}

TEST(Pillows, FourTrianglesWithoutStripsAreNoPillowOfQuads) {
  DualMesh mesh = quad_pillow();
  mesh.strip = {0, 0, 0, 0};
  EXPECT_EQ(drop_pillows(mesh), 0u);
}

TEST(Pillows, SolidsStay) {
  for (DualMesh mesh : {dual_mesh(kTetrahedron), dual_mesh(shapes::icosphere(1).triangles),
                        shapes::beach_ball(3), shapes::tight_torus(7, 1, 2)}) {
    const Index triangles = mesh.triangles();
    // Wherever a strip may be marked, a solid is no pillow.
    for (const char strip : {'\0', '\1', '\2', '\4'}) {
      mesh.strip.assign(triangles, strip);
      EXPECT_EQ(drop_pillows(mesh), 0u);
      EXPECT_EQ(kept_triangles(mesh), triangles);
    }
  }
}

TEST(Pillows, EachIsCountedAndNothingElseGoes) {
  std::vector<Triangle> triangles = kPillow;
  triangles = beside(triangles, kTetrahedron, 3);
  triangles = beside(triangles, kPillow, 7);
  triangles = beside(triangles, kPillow, 10);
  DualMesh mesh = dual_mesh(triangles);
  EXPECT_EQ(drop_pillows(mesh), 3u);
  EXPECT_EQ(kept_triangles(mesh), 4u);
  for (Index t = 2; t < 6; ++t) EXPECT_FALSE(mesh.dropped(t));
  find_loops(GridData(), mesh);
  EXPECT_EQ(mesh.vertices(), 4u) << "dropped triangles have no vertices";
}

// --- Loops ---------------------------------------------------------------------------------------

// Every half-edge belongs to the loop of its corner, and each loop is one ring.
void expect_loops(const DualMesh& mesh) {
  ASSERT_EQ(mesh.vertices(), mesh.leaf.size());
  std::vector<int> seen(mesh.vertex.size(), 0);
  for (Index v = 0; v < mesh.vertices(); ++v) {
    Index half_edge = mesh.first_half_edge[v];
    do {
      ASSERT_EQ(mesh.vertex[half_edge], v);
      ++seen[half_edge];
      half_edge = next_in_triangle(mesh.opposite[half_edge]);
    } while (half_edge != mesh.first_half_edge[v]);
  }
  for (Index h = 0; h < seen.size(); ++h) {
    ASSERT_EQ(seen[h], mesh.dropped(h / 3) ? 0 : 1) << "half-edge " << h;
  }
}

TEST(Loops, ATetrahedronHasFour) {
  DualMesh mesh = dual_mesh(kTetrahedron);
  find_loops(GridData(), mesh);
  EXPECT_EQ(mesh.vertices(), 4u);
  expect_loops(mesh);
  // One triangle's corners in the order in which they came.
  EXPECT_EQ(mesh.leaf, (std::vector<Index>{0, 1, 2, 3}));
}

TEST(Loops, LeavesWithSeveralPiecesGiveSeveralVertices) {
  // Two tetrahedra in the same four leaves.
  std::vector<Triangle> twice = kTetrahedron;
  twice.insert(twice.end(), kTetrahedron.begin(), kTetrahedron.end());
  std::vector<std::pair<Index, Index>> links;
  const DualMesh once = dual_mesh(kTetrahedron);
  for (Index h = 0; h < 12; ++h) {
    links.emplace_back(h, once.opposite[h]);
    links.emplace_back(12 + h, 12 + once.opposite[h]);
  }
  DualMesh mesh = dual_mesh(twice, links);
  find_loops(GridData(), mesh);
  EXPECT_EQ(mesh.vertices(), 8u);
  expect_loops(mesh);
  std::vector<Index> leaves = mesh.leaf;
  std::sort(leaves.begin(), leaves.end());
  EXPECT_EQ(leaves, (std::vector<Index>{0, 0, 1, 1, 2, 2, 3, 3}));
}

TEST(Loops, ClosedSurfacesHaveTheRightNumber) {
  for (Index disks = 2; disks < 6; ++disks) {
    DualMesh mesh = shapes::beach_ball(disks);
    find_loops(GridData(), mesh);
    EXPECT_EQ(mesh.vertices(), disks + 2);
    expect_loops(mesh);
  }
  for (Index n = 3; n < 12; ++n) {
    if ((2 % n) == 0 || (3 % n) == 0) continue;
    DualMesh mesh = shapes::tight_torus(n, 1, 2);
    find_loops(GridData(), mesh);
    EXPECT_EQ(mesh.vertices(), n);
    expect_loops(mesh);
  }
}

// --- Grids ---------------------------------------------------------------------------------------

TEST(Loops, OfAGridStayInTheirLeaves) {
  const Grid handle = build_grid(shapes::rotated(shapes::thin_walled_box(0.02), Vec3(3, 1, 2), 1),
                                 {.strategy = SplitStrategy::kUniform, .depth = 9});
  const GridData& grid = handle.data();
  DualMesh mesh = dual_mesh_of(grid);
  ASSERT_EQ(mesh.triangles(), grid.hits.size());
  const std::vector<Index> leaf_of_half_edge = mesh.vertex;
  for (Index h = 0; h < mesh.opposite.size(); ++h) {
    ASSERT_EQ(mesh.opposite[mesh.opposite[h]], h);
    // A half-edge runs from its own leaf to the one where its opposite starts.
    ASSERT_EQ(mesh.vertex[next_in_triangle(h)], mesh.vertex[mesh.opposite[h]]);
  }
  for (Index t = 0; t < mesh.triangles(); ++t) {
    const std::set<Index> leaves{mesh.vertex[3 * t], mesh.vertex[3 * t + 1],
                                 mesh.vertex[3 * t + 2]};
    ASSERT_EQ(leaves.size(), 3u) << "three leaves lie round a hit";
    for (const Index leaf : leaves) ASSERT_TRUE(grid.cells[leaf].leaf());
  }
  find_loops(grid, mesh);
  expect_loops(mesh);
  std::set<Index> leaves;
  for (Index h = 0; h < mesh.vertex.size(); ++h) {
    ASSERT_EQ(mesh.leaf[mesh.vertex[h]], leaf_of_half_edge[h]);
    leaves.insert(leaf_of_half_edge[h]);
  }
  EXPECT_GT(mesh.vertices(), leaves.size()) << "both sides of the wall share leaves";
}

// A tetrahedron near the origin, which two far boxes put in the middle of the root cell.
Mesh bulge(const Vec3& offset) {
  const Mesh far = shapes::box(Vec3(-64, -64, -64), Vec3(-63, -63, -63));
  const Mesh away = shapes::box(Vec3(63, 63, 63), Vec3(64, 64, 64));
  return shapes::merged({far, away, shapes::translated(shapes::tetrahedron(), offset)});
}

TEST(Loops, ABulgeThroughOneEdgeIsAPillowOfTheReport) {
  // Eight cells meet at the origin. Where the tetrahedron reaches over one of the edges between
  // them, the two hits there make a part without volume.
  int dropped = 0;
  for (int i = 0; i < 8; ++i) {
    const Grid grid = build_grid(bulge(Vec3(0.3 + 2.0 * i, 0.4, 0.2)),
                                 {.strategy = SplitStrategy::kUniform, .depth = 3});
    const ExtractedMesh strict = check::extract_any(grid);
    const ExtractedMesh raw = extract(grid, {.strict = Strict::kOff});
    EXPECT_EQ(raw.report.dropped_pillows, 0u);
    if (!strict.triangles.empty() && strict.report.dropped_pillows == 0) continue;
    ++dropped;
    EXPECT_LT(strict.triangles.size(), raw.triangles.size());
    if (!strict.triangles.empty()) {
      EXPECT_TRUE(check::is_two_manifold(strict));
    }
  }
  EXPECT_GT(dropped, 0);
}

}  // namespace
}  // namespace kdm
