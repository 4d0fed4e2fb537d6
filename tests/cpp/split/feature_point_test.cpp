// SPDX-License-Identifier: MIT
// Splits through features (paper 5.1.2 (2)).
#include "split/feature_point.h"

#include <gtest/gtest.h>

#include "kdmanifold/build.h"
#include "kdmanifold/extract.h"
#include "support/mesh_assert.h"
#include "support/shapes.h"

namespace kdm {
namespace {

class Feature : public testing::Test {
 protected:
  // The proposal for the part of the mesh within a box given in model coordinates.
  std::optional<Split> propose(const Mesh& mesh, const Vec3& low, const Vec3& high) {
    surface_ = prepare_surface(mesh);
    TriangleLists lists(surface_.triangles);
    const LatticeBox box{surface_.lattice.quantise(low), surface_.lattice.quantise(high)};
    return FeatureFinder(surface_).propose(box, lists.entries(lists.all()));
  }
  double place_of(const Split& split) const {
    Vec3 p = Vec3::Zero();
    p[split.axis] = split.value;
    return surface_.lattice.to_model(p)[split.axis];
  }

  Surface surface_;
};

// Fine enough for cells to hold whole triangles.
Mesh fine(Mesh mesh) {
  for (int i = 0; i < 4; ++i) mesh = shapes::subdivided(mesh);
  return mesh;
}

TEST_F(Feature, ACornerIsSplitThrough) {
  const auto split = propose(fine(shapes::cube()), Vec3(0.5, 0.45, 0.4), Vec3(1.3, 1.4, 1.5));
  ASSERT_TRUE(split);
  EXPECT_NEAR(place_of(*split), 1, 1e-4) << "whatever the axis, the corner is at 1";
}

TEST_F(Feature, ACreaseIsSplitAcrossNotAlong) {
  // Along x: the edge y = z = 1, without its ends.
  const auto split = propose(fine(shapes::cube()), Vec3(0.2, 0.6, 0.7), Vec3(0.8, 1.25, 1.3));
  ASSERT_TRUE(split);
  EXPECT_NE(split->axis, 0);
  EXPECT_NEAR(place_of(*split), 1, 1e-4);
}

TEST_F(Feature, FlatPartsHaveNone) {
  EXPECT_FALSE(propose(fine(shapes::cube()), Vec3(0.2, 0.2, 0.7), Vec3(0.8, 0.8, 1.3)));
}

TEST_F(Feature, EmptyAndTinyCellsHaveNone) {
  const Mesh cube = fine(shapes::cube());
  EXPECT_FALSE(propose(cube, Vec3(0.4, 0.4, 0.4), Vec3(0.6, 0.6, 0.6)));
  surface_ = prepare_surface(cube);
  TriangleLists lists(surface_.triangles);
  const LatticePoint corner = surface_.lattice.quantise(Vec3(1, 1, 1));
  LatticeBox box{corner, corner};
  for (int i = 0; i < 3; ++i) box.hi[i] += 1;
  EXPECT_FALSE(FeatureFinder(surface_).propose(box, lists.entries(lists.all())));
}

TEST_F(Feature, AFeatureNextToASideLeavesNoSliver) {
  const auto split = propose(fine(shapes::cube()), Vec3(0.5, 0.45, 0.4), Vec3(1.001, 1.001, 1.001));
  ASSERT_TRUE(split);
  const double low = 0.5 - 0.05 * split->axis;
  EXPECT_LT(place_of(*split), 1.001 - (1.001 - low) / 17);
}

// The rule as a whole: the same promises as the adaptive one.
TEST(FeatureRule, MeetsToleranceAndTopology) {
  for (const Mesh& mesh :
       {shapes::rotated(shapes::stairs(4), Vec3(1, 2, 3), 0.7), shapes::plate_with_holes(2, 2),
        shapes::torus(1, 0.4, 48, 24), shapes::thin_walled_box(0.02)}) {
    const check::MeshCheck input = check::check_mesh(mesh);
    const Grid grid =
        build_grid(mesh, {.strategy = SplitStrategy::kFeature, .relative_tolerance = 0.005});
    EXPECT_TRUE(grid.stats().topology_resolved);
    const check::MeshCheck result = check::check_mesh(extract(grid));
    EXPECT_TRUE(result.two_manifold) << result.faults();
    EXPECT_EQ(result.components, input.components);
    EXPECT_EQ(result.euler_characteristic, input.euler_characteristic);
    EXPECT_NEAR(result.volume, input.volume, 0.02 * input.volume);
  }
}

}  // namespace
}  // namespace kdm
