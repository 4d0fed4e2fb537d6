// SPDX-License-Identifier: MIT
// Scenes of small and thin parts: what separates them, and how few triangles they take.
#include "split/part_cuts.h"

#include <gtest/gtest.h>

#include "grid/grid_data.h"
#include "kdmanifold/build.h"
#include "kdmanifold/extract.h"
#include "support/mesh_assert.h"
#include "support/shapes.h"

namespace kdm {
namespace {

using shapes::box;
using shapes::merged;

Mesh post(double x) { return box(Vec3(x, 0, 0), Vec3(x + 0.06, 0.02, 0.9)); }

// Posts, and two rails behind them that touch none.
Mesh fence(int posts) {
  std::vector<Mesh> parts;
  for (int i = 0; i < posts; ++i) parts.push_back(post(0.2 * i));
  for (const double z : {0.2, 0.7}) {
    parts.push_back(box(Vec3(0, 0.03, z), Vec3(0.2 * posts, 0.05, z + 0.05)));
  }
  return merged(parts);
}

// Leaning round poles side by side, of 44 triangles each.
Mesh poles(int count) {
  std::vector<Mesh> parts;
  for (int i = 0; i < count; ++i) {
    const Mesh pole = shapes::rotated(shapes::cylinder(0.02, 10, 12), Vec3(1, 2, 3), 0.3 + 0.1 * i);
    parts.push_back(shapes::translated(pole, Vec3(20.0 * i, 0, 0)));
  }
  return merged(parts);
}

struct Listed {
  Surface surface;
  TriangleLists lists;
  explicit Listed(const Mesh& mesh) : surface(prepare_surface(mesh)), lists(surface.triangles) {}
  std::span<const ListEntry> entries() const { return lists.entries(lists.all()); }
};

TEST(PartCuts, CutBetweenParts) {
  //   | |        | |  | |     the gap on the left leaves one part and two, that on the right two
  //   0 1        9 10 11 12   and one; the left one is wider
  const Listed list(merged({box(Vec3(0, 0, 0), Vec3(1, 8, 8)), box(Vec3(9, 0, 0), Vec3(10, 8, 8)),
                            box(Vec3(11, 0, 0), Vec3(12, 8, 8))}));
  PartCuts cuts(list.surface);
  const std::optional<Split> split = cuts.propose(list.entries());
  ASSERT_TRUE(split);
  EXPECT_EQ(split->axis, 0);
  const Vec3 middle = list.surface.lattice.to_lattice(Vec3(5, 0, 0));
  EXPECT_NEAR(split->value, middle.x(), 1.0);
  EXPECT_TRUE(cuts.all_small(list.entries()));
}

TEST(PartCuts, PartsWithinEachOthersBoundsAreNotCut) {
  const Listed list(shapes::torus_chain(2));
  PartCuts cuts(list.surface);
  EXPECT_FALSE(cuts.propose(list.entries()));
  EXPECT_FALSE(cuts.all_small(list.entries())) << "2,304 triangles each";
}

TEST(PartCuts, OnePartIsNone) {
  const Listed list(shapes::cube());
  PartCuts cuts(list.surface);
  EXPECT_FALSE(cuts.propose(list.entries()));
  EXPECT_FALSE(cuts.all_small(list.entries()));
}

TEST(PartCuts, ALargePartIsNotSmall) {
  const Listed list(
      merged({shapes::icosphere(5), shapes::translated(shapes::cube(), Vec3(3, 0, 0))}));
  const PartCuts cuts(list.surface);
  const std::span<const ListEntry> all = list.entries();
  constexpr std::size_t kSphere = 20 << 10;
  EXPECT_FALSE(cuts.all_small(all.first(kSphere)));
  EXPECT_TRUE(cuts.all_small(all.subspan(kSphere)));
  EXPECT_FALSE(cuts.all_small(all));
}

TEST(PartCuts, ABoxTakesItsTwelveTriangles) {
  for (const double tolerance : {0.2, 0.02, 0.002}) {
    const Grid grid = build_grid(merged({post(0), post(0.5), post(0.7)}), {.tolerance = tolerance});
    EXPECT_TRUE(grid.stats().topology_resolved);
    const ExtractedMesh out = extract(grid);
    EXPECT_EQ(out.triangles.size(), 36u) << tolerance;
    const check::MeshCheck result = check::check_mesh(out);
    EXPECT_EQ(result.components, 3);
    EXPECT_NEAR(result.volume, 3 * 0.06 * 0.02 * 0.9, 1e-7) << tolerance;
  }
}

// As many parts, each a topological sphere, of no more triangles than that on average.
void expect_spheres(const Grid& grid, int parts, std::size_t most_triangles) {
  EXPECT_TRUE(grid.stats().topology_resolved);
  const ExtractedMesh out = extract(grid);
  const check::MeshCheck result = check::check_mesh(out);
  EXPECT_TRUE(result.two_manifold) << result.faults();
  EXPECT_EQ(result.components, parts);
  EXPECT_EQ(result.euler_characteristic, 2 * parts);
  EXPECT_LE(out.triangles.size(), most_triangles * parts);
}

TEST(PartCuts, AFenceTakesFewTrianglesAPart) {
  constexpr int kPosts = 40;
  expect_spheres(build_grid(fence(kPosts), {.tolerance = 0.2}), kPosts + 2, 14);
}

TEST(PartCuts, LeaningPolesComeOutWhole) {
  constexpr int kPoles = 6;
  expect_spheres(build_grid(poles(kPoles), {.tolerance = 0.1}), kPoles, 460);
}

// Where shells cross curves may stay closed at any size: the search for their middle ends.
TEST(PartCuts, ShellsThatCrossEverywhereEnd) {
  std::vector<Mesh> parts;
  for (int i = 0; i < 6; ++i) parts.push_back(shapes::rotated(post(0), Vec3(1, i, 3), 0.3 + i));
  const Grid grid = build_grid(merged(parts), {.tolerance = 0.01});
  EXPECT_LT(grid.stats().cells, 20000u);
  const check::MeshCheck result = check::check_mesh(extract(grid));
  EXPECT_TRUE(result.two_manifold) << result.faults();
}

}  // namespace
}  // namespace kdm
