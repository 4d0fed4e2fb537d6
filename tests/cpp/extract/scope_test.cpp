// SPDX-License-Identifier: MIT
// Passes over everything against the same passes over a list of everything, and over nothing.
#include "extract/dual/scope.h"

#include <gtest/gtest.h>

#include <numeric>

#include "extract/mend/double_edges.h"
#include "extract/mend/unfold.h"
#include "extract/place/place.h"
#include "extract/place/refine.h"
#include "extract/place/split_vertices.h"
#include "kdmanifold/build.h"
#include "support/dual_mesh_check.h"
#include "support/dual_mesh_shapes.h"
#include "support/shapes.h"

namespace kdm {
namespace {

std::vector<Index> all_below(Index count) {
  std::vector<Index> numbers(count);
  std::iota(numbers.begin(), numbers.end(), Index{0});
  return numbers;
}

std::vector<Index> visited(const Scope& scope, Index count) {
  std::vector<Index> numbers;
  scope.for_each(count, [&](Index i) { numbers.push_back(i); });
  return numbers;
}

TEST(Scope, EverythingIsAllNumbers) {
  const Scope all;
  EXPECT_TRUE(all.is_all());
  EXPECT_TRUE(all.contains(1000));
  EXPECT_EQ(visited(all, 4), (std::vector<Index>{0, 1, 2, 3}));
}

TEST(Scope, AListIsItsNumbers) {
  const std::vector<Index> numbers = {2, 3, 7};
  const Scope some = numbers;
  EXPECT_FALSE(some.is_all());
  EXPECT_TRUE(some.contains(3));
  EXPECT_FALSE(some.contains(4));
  EXPECT_EQ(visited(some, 100), numbers);
  const std::vector<Index> nothing;
  EXPECT_FALSE(Scope(nothing).is_all());
  EXPECT_TRUE(visited(nothing, 100).empty());
}

// A mesh of one triangle a hit, its vertices placed.
struct Placed {
  explicit Placed(const Mesh& input)
      : handle(build_grid(input, {.strategy = SplitStrategy::kOctree, .depth = 12})),
        grid(handle.data()),
        boxes(cell_boxes(grid)),
        points(hit_points(grid, boxes)),
        mesh(dual_mesh_of(grid)) {
    drop_pillows(mesh);
    find_loops(grid, mesh);
    place_vertices(view(), settings, mesh);
  }
  GridView view() const { return {grid, boxes, points}; }

  Grid handle;
  const GridData& grid;
  std::vector<LatticeBox> boxes;
  std::vector<Vec3> points;
  FaceSettings settings{.split_error = {.distance = 0.5 / 4096}};
  DualMesh mesh;
};

void expect_same(const DualMesh& a, const DualMesh& b) {
  EXPECT_EQ(a.vertex, b.vertex);
  EXPECT_EQ(a.opposite, b.opposite);
  EXPECT_EQ(a.hit, b.hit);
  EXPECT_EQ(a.position, b.position);
}

// Runs the pass over everything, over a list of everything and over nothing, each on a mesh of its
// own. `run(mesh, log, scope)` returns how much it did.
template <typename Run>
DualMesh expect_alike(const DualMesh& mesh, Index count, const Run& run) {
  DualMesh by_all = mesh;
  DualMesh by_list = mesh;
  DualMesh by_none = mesh;
  EditLog log;
  EditLog log_of_list;
  EditLog log_of_none;
  const std::vector<Index> everything = all_below(count);
  const std::vector<Index> nothing;
  const Index done = run(by_all, log, Scope());
  EXPECT_GT(done, 0u);
  EXPECT_EQ(run(by_list, log_of_list, Scope(everything)), done);
  EXPECT_EQ(run(by_none, log_of_none, Scope(nothing)), 0u);
  expect_same(by_all, by_list);
  expect_same(by_none, mesh);
  EXPECT_EQ(log.touched_hits(), log_of_list.touched_hits());
  EXPECT_TRUE(log_of_none.touched_hits().empty());
  check::expect_sound(by_all);
  return by_all;
}

TEST(Scope, PassesOverEverythingAreThoseOverAListOfEverything) {
  const Placed placed(shapes::rotated(shapes::stairs(4), Vec3(1, 2, 3), 0.7));
  const GridView view = placed.view();
  const DualMesh split = expect_alike(
      placed.mesh, placed.mesh.vertices(), [&](DualMesh& mesh, EditLog& log, const Scope& scope) {
        return split_vertices(view, placed.settings, mesh, log, scope);
      });
  const auto hits = static_cast<Index>(placed.grid.hits.size());
  const DualMesh refined =
      expect_alike(split, hits, [&](DualMesh& mesh, EditLog& log, const Scope& scope) {
        return refine(view, {}, placed.grid.tolerance / 8, mesh, log, scope);
      });
  expect_alike(refined, refined.triangles(), [&](DualMesh& mesh, EditLog& log, const Scope& scope) {
    return unfold(view, {}, mesh, log, scope);
  });
}

// Which of several edges stays whole depends on the scope, their number does not.
TEST(Scope, DoubleEdgesAreSeparatedAsOftenByAList) {
  for (Index disks = 2; disks <= 5; ++disks) {
    DualMesh by_all = shapes::beach_ball(disks);
    find_loops(GridData(), by_all);
    by_all.position.assign(by_all.vertices(), Vec3::Zero());
    DualMesh by_list = by_all;
    GridData grid;
    grid.planes.push_back({Vec3(0, 0, 1), 0});
    grid.hits.assign(by_all.triangles(), Hit(0, 0, false, false));
    const std::vector<Vec3> points(by_all.triangles(), Vec3::Zero());
    EditLog log;
    const std::vector<Index> everything = all_below(by_all.vertices());
    EXPECT_EQ(separate_double_edges({grid, {}, points}, by_all, log), disks - 1);
    EXPECT_EQ(separate_double_edges({grid, {}, points}, by_list, log, everything), disks - 1);
    check::expect_sound(by_list);
  }
}

}  // namespace
}  // namespace kdm
