// SPDX-License-Identifier: MIT
// Needles, folds and triangles without area: by hand, and on models.
#include "extract/mend/slivers.h"

#include <gtest/gtest.h>

#include "extract/emit.h"
#include "extract/mend/give_area.h"
#include "extract/mend/triangle_shape.h"
#include "extract/place/place.h"
#include "extract/place/vertex_position.h"
#include "kdmanifold/build.h"
#include "kdmanifold/extract.h"
#include "support/dual_mesh_shapes.h"
#include "support/mesh_assert.h"
#include "support/random_meshes.h"
#include "support/sanitized.h"
#include "support/shapes.h"

namespace kdm {
namespace {

std::vector<Mesh> sliver_models() {
  std::vector<Mesh> models = {shapes::rotated(shapes::stairs(4), Vec3(1, 2, 3), 0.7),
                              shapes::rotated(shapes::plate_with_holes(2, 2), Vec3(3, 1, 2), 1),
                              shapes::glass(0.02),
                              shapes::swiss_cheese(5),
                              shapes::torus_chain(2),
                              shapes::icosphere(3)};
  for (std::uint32_t seed = 0; seed < 3; ++seed) {
    models.push_back(shapes::random_tetrahedra(12, seed));
    models.push_back(shapes::random_voxels(4, 0.5, seed));
  }
  return models;
}

std::vector<BuildOptions> rules() {
  return {{.relative_tolerance = 0.005},
          {.strategy = SplitStrategy::kOctree, .depth = 15},
          {.strategy = SplitStrategy::kMedian, .depth = 13},
          {.strategy = SplitStrategy::kUniform, .depth = 12}};
}

// What `extract` has when the loops' vertices are placed.
struct PlacedLoops {
  PlacedLoops(const Mesh& input, const BuildOptions& options)
      : handle(build_grid(input, options)),
        grid(handle.data()),
        boxes(cell_boxes(grid)),
        points(hit_points(grid, boxes)),
        mesh(dual_mesh_of(grid)) {
    drop_pillows(mesh);
    find_loops(grid, mesh);
    place_vertices(view(), {}, mesh);
  }

  GridView view() const { return {grid, boxes, points}; }

  std::vector<Index> ring(Index v) const {
    std::vector<Index> hits;
    for (const HalfEdgeId h : mesh.ring(v)) hits.push_back(h / 3);
    return hits;
  }

  TriangleShape shape_of(Index t) const {
    return {mesh.position[mesh.vertex[3 * t]], mesh.position[mesh.vertex[3 * t + 1]],
            mesh.position[mesh.vertex[3 * t + 2]]};
  }

  double least_sine_of(Index t) const { return shape_of(t).least_sine(); }

  bool folded(Index t) const {
    return least_sine_of(t) >= kThinSine &&
           shape_of(t).alignment(grid.plane_of(t).normal) < kFolded;
  }

  std::size_t folds() const {
    std::size_t count = 0;
    for (Index t = 0; t < mesh.triangles(); ++t) count += !mesh.dropped(t) && folded(t) ? 1 : 0;
    return count;
  }

  Grid handle;
  const GridData& grid;
  std::vector<LatticeBox> boxes;
  std::vector<Vec3> points;
  DualMesh mesh;
};

TEST(Slivers, VerticesStayInTheirLeavesAndNearTheirPlanes) {
  std::size_t moves = 0;
  std::size_t folds_before = 0;
  std::size_t folds_after = 0;
  for (const Mesh& model : sliver_models()) {
    for (const BuildOptions& options : rules()) {
      PlacedLoops placed(model, options);
      const std::vector<Vec3> before = placed.mesh.position;
      folds_before += placed.folds();
      moves += move_off_slivers(placed.view(), placed.mesh);
      folds_after += placed.folds();
      for (Index v = 0; v < before.size(); ++v) {
        const Vec3& p = placed.mesh.position[v];
        if (p == before[v]) continue;
        const LatticeBox& box = placed.boxes[placed.mesh.leaf[v]];
        ASSERT_TRUE((p.array() >= to_vec3(box.lo).array()).all());
        ASSERT_TRUE((p.array() <= to_vec3(box.hi).array()).all());
        const std::vector<Index> ring = placed.ring(v);
        ASSERT_LE(distance_to_planes(placed.grid, ring, p),
                  std::max(distance_to_planes(placed.grid, ring, before[v]),
                           0.5 * placed.grid.tolerance));
      }
    }
  }
  EXPECT_GT(moves, 50u);
  EXPECT_LT(folds_after, folds_before);
}

// Two leaves whose vertices are put on one point of an upright plane, and what is done about it.
TEST(Slivers, VerticesAtOnePointArePartedInThePlane) {
  PlacedLoops placed(shapes::scaled(shapes::cube(), Vec3(3, 2, 1)),
                     {.strategy = SplitStrategy::kUniform, .depth = 9});
  Index t = 0;
  const auto corners = [&](Index i) { return placed.mesh.vertex[3 * t + i]; };
  const auto all_of_one_plane = [&](Index v) {
    const std::vector<Index> ring = placed.ring(v);
    return std::all_of(ring.begin(), ring.end(), [&](Index h) {
      return placed.grid.plane_of(h).normal == placed.grid.plane_of(t).normal;
    });
  };
  while (t < placed.mesh.triangles() &&
         !(all_of_one_plane(corners(0)) && all_of_one_plane(corners(1)))) {
    ++t;
  }
  ASSERT_LT(t, placed.mesh.triangles());
  // On the common side of the two leaves.
  const Vec3 middle = 0.5 * (placed.mesh.position[corners(0)] + placed.mesh.position[corners(1)]);
  for (const Index i : {0, 1}) placed.mesh.position[corners(i)] = middle;
  ASSERT_EQ(placed.least_sine_of(t), 0);
  EXPECT_EQ(move_off_slivers(placed.view(), placed.mesh), 1u);
  for (const Index i : {0, 1}) {
    for (const Index h : placed.ring(corners(i))) EXPECT_GT(placed.least_sine_of(h), kThinSine);
  }
}

TEST(Slivers, RimsStay) {
  PlacedLoops placed(shapes::open(shapes::icosphere(2), 40),
                     {.relative_tolerance = 0.02, .inside = InsideRule::kSheet});
  ASSERT_FALSE(placed.grid.rims.empty());
  EXPECT_EQ(move_off_slivers(placed.view(), placed.mesh), 0u);
}

bool flat_in_single_precision(const Mesh& mesh, const Triangle& t) {
  const auto corner = [&](int i) {
    return Vec3(mesh.positions[t[static_cast<std::size_t>(i)]].cast<float>().cast<double>());
  };
  return is_flat(corner(0), corner(1), corner(2));
}

TEST(Slivers, TrianglesGetAnAreaThat32BitsShow) {
  for (const Vec3& where : {Vec3(0, 0, 0), Vec3(1000, -2000, 50)}) {
    PlacedLoops placed(shapes::translated(shapes::icosphere(3), where),
                       {.strategy = SplitStrategy::kOctree, .depth = 12});
    DualMesh& mesh = placed.mesh;
    EXPECT_EQ(give_area(placed.view(), mesh), 0u);
    // Every tenth triangle has two corners at one point, or three on one line.
    for (Index t = 0; t < mesh.triangles(); t += 10) {
      Vec3& a = mesh.position[mesh.vertex[3 * t]];
      const Vec3& b = mesh.position[mesh.vertex[3 * t + 1]];
      const Vec3& c = mesh.position[mesh.vertex[3 * t + 2]];
      a = t % 20 == 0 ? b : Vec3(0.5 * (b + c));
    }
    const std::vector<Vec3> before = mesh.position;
    const Index moves = give_area(placed.view(), mesh);
    EXPECT_GT(moves, mesh.triangles() / 20);
    for (Index v = 0; v < before.size(); ++v) {
      // A vertex may be moved for several triangles.
      EXPECT_LE((mesh.position[v] - before[v]).norm(), 2 * placed.grid.tolerance);
    }
    const Mesh out = emit(placed.grid, mesh, {}, false, false);
    for (const Triangle& t : out.triangles) EXPECT_FALSE(flat_in_single_precision(out, t));
  }
}

TEST(Slivers, FarOffNothingIsTried) {
  PlacedLoops placed(shapes::translated(shapes::icosphere(3), Vec3(1e8, 0, 0)),
                     {.strategy = SplitStrategy::kOctree, .depth = 12});
  EXPECT_EQ(give_area(placed.view(), placed.mesh), 0u);
}

TEST(Slivers, NoResultHasATriangleWithoutArea) {
  for (const Mesh& model : sliver_models()) {
    for (const BuildOptions& options : rules()) {
      if (check::kSanitized && options.strategy == SplitStrategy::kOctree) continue;
      const Grid grid = build_grid(model, options);
      for (const VertexPosition position :
           {VertexPosition::kConstrained, VertexPosition::kProjection}) {
        if (check::kSanitized && position == VertexPosition::kProjection) continue;
        const ExtractedMesh out = extract(grid, {.position = position});
        ASSERT_TRUE(check::is_two_manifold(out));
        for (const Triangle& t : out.triangles) ASSERT_FALSE(flat_in_single_precision(out, t));
      }
    }
  }
}

}  // namespace
}  // namespace kdm
