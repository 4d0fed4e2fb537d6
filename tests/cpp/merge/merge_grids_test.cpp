// SPDX-License-Identifier: MIT
#include "kdmanifold/merge.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>

#include "grid/splitting_edges.h"
#include "grid/validate.h"
#include "kdmanifold/boolean.h"
#include "kdmanifold/build.h"
#include "kdmanifold/error.h"
#include "kdmanifold/extract.h"
#include "kdmanifold/grid_io.h"
#include "kdmanifold/simplify.h"
#include "support/grid_compare.h"
#include "support/mesh_assert.h"
#include "support/random.h"
#include "support/shapes.h"

namespace kdm {
namespace {

constexpr BoxCorners kRoom = {-3, -3, -3, 3, 3, 3};
constexpr double kNear = 0.01;  // the tolerance

Grid grid_of(const Mesh& mesh, BuildOptions options = {.tolerance = kNear}) {
  options.box = kRoom;
  return build_grid(mesh, options);
}

const std::vector<Expression>& all_operations() {
  static const std::vector<Expression> kAll = {union_of(0, 1), intersection(0, 1), difference(0, 1),
                                               symmetric_difference(0, 1)};
  return kAll;
}

// Checks what must hold of any merge, and returns the volume of what is extracted.
double volume_of(const Grid& merged) {
  EXPECT_NO_THROW(validate(merged.data()));
  const ExtractedMesh mesh = extract(merged);
  EXPECT_TRUE(check::is_two_manifold(mesh));
  EXPECT_EQ(mesh.report.crossings, 0u);
  return shapes::signed_volume(mesh);
}

// The same of meshes that are at hand; 0 if nothing is left.
double volume_of_meshes(const Mesh& a, const Mesh& b, const Expression& expression) {
  try {
    return shapes::signed_volume(
        extract(build_csg_grid({a, b}, expression, {.tolerance = kNear / 4})));
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kEmptyResult);
    return 0;
  }
}

ErrorCode code_of(const Grid& a, const Grid& b, const Expression& expression,
                  const Progress& progress = {}) {
  try {
    merge_grids(a, b, expression, progress);
  } catch (const Error& error) {
    return error.code();
  }
  return ErrorCode::kInternal;
}

// Hits by where they are and which way the surface is turned there.
std::set<std::array<std::int64_t, 5>> places_of_hits(const Grid& grid) {
  const GridData& data = grid.data();
  std::set<std::array<std::int64_t, 5>> places;
  for_each_splitting_edge(data, cell_boxes(data), [&](const SplittingEdge& edge) {
    const LatticePoint low = edge.low();
    for (const HitId h : edge.hits) {
      const Hit& hit = data.hits[h];
      places.insert({edge.axis, low[next_axis(edge.axis)], low[previous_axis(edge.axis)],
                     hit.position, hit.leaving() ? 1 : 0});
    }
  });
  return places;
}

TEST(MergeGrids, MergesTwoBoxesExactly) {
  const Grid a = grid_of(shapes::box(Vec3(-1, -1, -1), Vec3(1, 1, 1)));
  const Grid b = grid_of(shapes::box(Vec3(0.3, 0.2, 0.1), Vec3(2, 2, 2)));
  const double common = 0.7 * 0.8 * 0.9;
  const double of_b = 1.7 * 1.8 * 1.9;
  EXPECT_NEAR(volume_of(merge_grids(a, b, union_of(0, 1))), 8 + of_b - common, 1e-4);
  EXPECT_NEAR(volume_of(merge_grids(a, b, intersection(0, 1))), common, 1e-4);
  EXPECT_NEAR(volume_of(merge_grids(a, b, difference(0, 1))), 8 - common, 1e-4);
  EXPECT_NEAR(volume_of(merge_grids(a, b, difference(1, 0))), of_b - common, 1e-4);
  // Where the two parts of it touch, they are kept apart.
  EXPECT_NEAR(volume_of(merge_grids(a, b, symmetric_difference(0, 1))), 8 + of_b - 2 * common,
              kNear);
}

TEST(MergeGrids, JoinsFacesOnFaces) {
  const Mesh left = shapes::box(Vec3(-1, -1, -1), Vec3(0, 0, 0));
  const Mesh right = shapes::box(Vec3(0, -1, -1), Vec3(1, 0, 0));
  const Grid both = merge_grids(grid_of(left), grid_of(right), union_of(0, 1));
  EXPECT_NEAR(volume_of(both), 2, 1e-4);
  EXPECT_EQ(check::check_mesh(extract(both)).components, 1);
  EXPECT_EQ(code_of(grid_of(left), grid_of(right), intersection(0, 1)), ErrorCode::kEmptyResult);
  // Tilted, they are rounded into each other here and apart there.
  const Grid tilted =
      merge_grids(grid_of(shapes::turned(left)), grid_of(shapes::turned(right)), union_of(0, 1));
  EXPECT_NEAR(volume_of(tilted), 2, kNear);
}

// Many of them touch, or have faces on faces.
TEST(MergeGrids, MergesRandomSolids) {
  check::Random random(5);
  const auto solid = [&] {
    const std::vector<Mesh> kinds = {shapes::box(Vec3(-1, -1, -1), Vec3(1, 1, 1)),
                                     shapes::icosphere(3), shapes::torus(1, 0.3, 32, 16),
                                     shapes::cylinder(0.7, 1.4, 12)};
    Mesh mesh = kinds[random.below(4)];
    if (random.below(2) == 0) mesh = shapes::turned(mesh);
    Vec3 by(random.between(-1, 1), random.between(-1, 1), random.between(-1, 1));
    if (random.below(2) == 0) by = (2 * by.array()).round() / 2;
    return shapes::translated(mesh, by);
  };
  for (int i = 0; i < 12; ++i) {
    const Mesh first = solid();
    const Mesh second = i % 4 == 0 ? shapes::translated(first, Vec3(0.5, 0, 0)) : solid();
    const Grid a = grid_of(first);
    const Grid b = grid_of(second);
    for (const Expression& expression : all_operations()) {
      const double exact = volume_of_meshes(first, second, expression);
      constexpr double kOfArea = 10;  // the solids' surfaces are no larger
      if (code_of(a, b, expression) == ErrorCode::kEmptyResult) {
        EXPECT_LT(exact, kNear * kOfArea);
      } else {
        EXPECT_NEAR(volume_of(merge_grids(a, b, expression)), exact, kNear * kOfArea) << i;
      }
    }
  }
}

TEST(MergeGrids, KeepsTheHitsOfWhatOneGridHasAlone) {
  const Grid ring = grid_of(shapes::turned(shapes::torus(1, 0.3, 64, 32)));
  const Grid ball = grid_of(shapes::translated(shapes::icosphere(3, 0.5), Vec3(2, 2, 2)));
  const std::set merged = places_of_hits(merge_grids(ring, ball, union_of(0, 1)));
  for (const Grid* grid : {&ring, &ball}) {
    for (const auto& place : places_of_hits(*grid)) EXPECT_TRUE(merged.count(place));
  }
  // The ball cuts a piece off; all of the ring beyond it stays.
  const Grid cutter = grid_of(shapes::translated(shapes::icosphere(3, 0.8), Vec3(1.2, 0, 0)));
  const std::set cut = places_of_hits(merge_grids(ring, cutter, difference(0, 1)));
  const Lattice& lattice = ring.data().lattice;
  int kept = 0;
  for (const auto& place : places_of_hits(ring)) {
    Vec3 point;
    const auto axis = static_cast<int>(place[0]);
    point[axis] = real_position(static_cast<LinePosition>(place[3]));
    point[next_axis(axis)] = static_cast<double>(place[1]);
    point[previous_axis(axis)] = static_cast<double>(place[2]);
    const double away = (lattice.to_model(point) - Vec3(1.2, 0, 0)).norm();
    if (away < 0.85) continue;
    EXPECT_TRUE(cut.count(place));
    ++kept;
  }
  EXPECT_GT(kept, 500);
}

// Links too: what is extracted of a solid that the other one does not come near is the same.
TEST(MergeGrids, TakesOverCellsAndLinksBesideAnEmptyPlace) {
  const Grid ring = grid_of(shapes::turned(shapes::torus(1, 0.3, 64, 32)));
  const Grid inside = grid_of(shapes::translated(shapes::icosphere(2, 0.1), Vec3(2.8, 2.8, 2.8)));
  const Grid merged = merge_grids(ring, inside, difference(0, 1));
  EXPECT_EQ(places_of_hits(merged), places_of_hits(ring));
  const ExtractedMesh before = extract(ring);
  const ExtractedMesh after = extract(merged);
  EXPECT_EQ(after.positions, before.positions);
  EXPECT_EQ(after.triangles, before.triangles);
  EXPECT_EQ(after.source_faces, before.source_faces);
  EXPECT_EQ(after.source_operands, std::vector<Index>(after.triangles.size(), 0));
  EXPECT_TRUE(merged.stats().topology_resolved);
}

TEST(MergeGrids, KnowsAGridThatIsMergedWithItself) {
  const Grid ring = grid_of(shapes::turned(shapes::torus(1, 0.3, 64, 32)));
  for (const Expression& expression : {union_of(0, 1), intersection(0, 1)}) {
    const Grid merged = merge_grids(ring, ring, expression);
    EXPECT_EQ(places_of_hits(merged), places_of_hits(ring));
    const ExtractedMesh before = extract(ring);
    const ExtractedMesh after = extract(merged);
    EXPECT_EQ(after.positions, before.positions);
    EXPECT_EQ(after.triangles, before.triangles);
  }
  EXPECT_EQ(code_of(ring, ring, difference(0, 1)), ErrorCode::kEmptyResult);
  EXPECT_EQ(code_of(ring, ring, symmetric_difference(0, 1)), ErrorCode::kEmptyResult);
}

TEST(MergeGrids, MergesSavedGridsToTheSameBytes) {
  const Grid a = grid_of(shapes::icosphere(3));
  const Grid b = grid_of(shapes::turned(shapes::torus(1, 0.3, 64, 32)));
  const Grid a_again = load_grid(save_grid(a));
  const Grid b_again = load_grid(save_grid(b));
  for (const Expression& expression : all_operations()) {
    const Grid merged = merge_grids(a, b, expression);
    const auto bytes = save_grid(merged);
    EXPECT_EQ(save_grid(merge_grids(a_again, b_again, expression)), bytes);
    check::expect_same(load_grid(bytes), merged);
  }
}

TEST(MergeGrids, MergesWhatWasMergedAndNamesAllOperands) {
  const Grid a = grid_of(shapes::box(Vec3(-1, -1, -1), Vec3(1, 1, 1)));
  const Grid b = grid_of(shapes::box(Vec3(0, 0, 0), Vec3(2, 2, 2)));
  const Grid c = grid_of(shapes::box(Vec3(-2, -2, -2), Vec3(-0.5, -0.5, -0.5)));
  const Grid all = merge_grids(merge_grids(a, b, union_of(0, 1)), c, union_of(0, 1));
  EXPECT_NEAR(volume_of(all), 8 + 7 + 3.375 - 0.125, 1e-3);
  ASSERT_EQ(all.operands().size(), 3u);
  EXPECT_EQ(all.input().triangles, 36u);
  const ExtractedMesh mesh = extract(all);
  std::set<Index> operands(mesh.source_operands.begin(), mesh.source_operands.end());
  EXPECT_EQ(operands, (std::set<Index>{0, 1, 2}));
}

TEST(MergeGrids, MergesGridsOfAllKinds) {
  const Mesh ball = shapes::icosphere(3);
  const Mesh ring = shapes::turned(shapes::torus(1, 0.4, 48, 24));
  const double exact = volume_of_meshes(ball, ring, union_of(0, 1));
  const Grid b = grid_of(ring);
  Grid simplified = grid_of(ball);
  simplify(simplified, {.surface_error = 2 * kNear});
  EXPECT_NEAR(volume_of(merge_grids(simplified, b, union_of(0, 1))), exact, 0.2);
  const Grid uniform = grid_of(ball, {.strategy = SplitStrategy::kUniform, .depth = 12});
  EXPECT_NEAR(volume_of(merge_grids(uniform, b, union_of(0, 1))), exact, 0.2);
  EXPECT_NEAR(volume_of(merge_grids(b, uniform, union_of(0, 1))), exact, 0.2);
  const Grid octree = grid_of(ball, {.strategy = SplitStrategy::kOctree, .tolerance = kNear});
  EXPECT_NEAR(volume_of(merge_grids(octree, b, union_of(0, 1))), exact, 0.1);
  EXPECT_NEAR(volume_of(merge_grids(octree, uniform, union_of(0, 1))), 4.18, 0.2);
}

TEST(MergeGrids, SaysWhereTopologyIsNotCertified) {
  const Grid a = grid_of(shapes::icosphere(3));
  const Grid b = grid_of(shapes::translated(shapes::icosphere(3), Vec3(0.4, 0.3, 0.2)));
  ASSERT_TRUE(a.stats().topology_resolved && b.stats().topology_resolved);
  EXPECT_FALSE(merge_grids(a, b, union_of(0, 1)).stats().topology_resolved);
}

// A wire about as thin as the tolerance is kept without cells.
TEST(MergeGrids, MergesThinPartsAwayFromTheOtherSurface) {
  const Mesh wire = shapes::translated(
      shapes::scaled(shapes::cylinder(1, 1, 24), Vec3(0.004, 0.004, 1)), Vec3(0.3, 0.2, 0.1));
  const Grid a = grid_of(shapes::merged({shapes::box(Vec3(-2, -2, -2), Vec3(-1, -1, -1)), wire}));
  ASSERT_EQ(a.stats().exact_parts, 1u);
  const double volume = shapes::signed_volume(wire);
  const Grid apart = grid_of(shapes::box(Vec3(1, 1, -2), Vec3(2, 2, -1)));
  EXPECT_NEAR(volume_of(merge_grids(a, apart, union_of(0, 1))), 2 + volume, 1e-6);
  EXPECT_EQ(merge_grids(a, apart, union_of(0, 1)).stats().exact_parts, 1u);
  const Grid around = grid_of(shapes::box(Vec3(-0.5, -0.5, -0.5), Vec3(2, 2, 2)));
  EXPECT_EQ(merge_grids(a, around, union_of(0, 1)).stats().exact_parts, 0u);
  EXPECT_NEAR(volume_of(merge_grids(around, a, difference(0, 1))), 2.5 * 2.5 * 2.5 - volume, 1e-6);
  const Grid across = grid_of(shapes::box(Vec3(-0.5, -0.5, -0.5), Vec3(2, 2, 0.5)));
  EXPECT_EQ(code_of(a, across, union_of(0, 1)), ErrorCode::kInvalidOption);
}

TEST(MergeGrids, RefusesWhatCannotBeMerged) {
  const Grid a = grid_of(shapes::icosphere(2));
  const Grid elsewhere = build_grid(shapes::icosphere(2), {.tolerance = kNear});
  const Grid sheet = grid_of(shapes::open(shapes::icosphere(2)),
                             {.tolerance = kNear, .inside = InsideRule::kSheet});
  EXPECT_EQ(code_of(a, elsewhere, union_of(0, 1)), ErrorCode::kInvalidOption);
  EXPECT_EQ(code_of(a, sheet, union_of(0, 1)), ErrorCode::kInvalidOption);
  EXPECT_EQ(code_of(a, a, union_of(0, 2)), ErrorCode::kInvalidOption);
  EXPECT_EQ(code_of(a, a, complement(0)), ErrorCode::kInvalidOption);
  try {
    merge_grids(a, elsewhere, union_of(0, 1));
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("`box`"), std::string::npos);
  }
}

TEST(MergeGrids, StopsWhenItIsAskedTo) {
  const Grid a = grid_of(shapes::icosphere(3));
  const Grid b = grid_of(shapes::translated(shapes::icosphere(3), Vec3(0.4, 0.3, 0.2)));
  const auto before = save_grid(a);
  double last = 0;
  const auto until = [&](double end) {
    return [&last, end](double fraction, std::string_view) {
      EXPECT_GE(fraction, last);
      last = fraction;
      return fraction < end;
    };
  };
  for (const double end : {0.0, 0.1, 0.8, 1.0}) {
    last = 0;
    EXPECT_EQ(code_of(a, b, union_of(0, 1), until(end)), ErrorCode::kAborted);
  }
  EXPECT_EQ(save_grid(a), before);
  EXPECT_GT(volume_of(merge_grids(a, b, union_of(0, 1))), 4.5);
}

TEST(BuildOptions, BoxGivesDifferentModelsOneLattice) {
  const Grid a = grid_of(shapes::icosphere(2));
  const Grid b = grid_of(shapes::torus());
  EXPECT_EQ(a.data().lattice, b.data().lattice);
  EXPECT_EQ(grid_of(shapes::box(Vec3(-3, -3, -3), Vec3(3, 3, 3))).data().lattice, a.data().lattice);
  try {
    grid_of(shapes::icosphere(1, 4));
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kInvalidOption);
    EXPECT_EQ(std::string(error.what()).rfind("`box`: ", 0), 0u) << error.what();
  }
}

}  // namespace
}  // namespace kdm
