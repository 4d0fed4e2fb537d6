// SPDX-License-Identifier: MIT
#include "mesh/pinches.h"

#include <gtest/gtest.h>

#include "support/shapes.h"

namespace kdm {
namespace {

Marks pinched_of(const Mesh& mesh) {
  const auto points = static_cast<Index>(mesh.positions.size());
  return find_pinched(mesh.triangles, points, build_topology(mesh.triangles, points));
}

TEST(Pinches, AManifoldHasNone) {
  EXPECT_FALSE(pinched_of(shapes::torus()).any());
  EXPECT_FALSE(pinched_of(shapes::nested_shells()).any());
}

// Marks are just at the corners of both cubes that lie there.
void expect_marks_at(const Mesh& mesh, const std::vector<Vec3>& places) {
  const Marks pinched = pinched_of(mesh);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    bool there = false;
    for (const Index corner : mesh.triangles[t]) {
      for (const Vec3& place : places) there = there || mesh.positions[corner] == place;
    }
    EXPECT_EQ(pinched.test(t), there) << "triangle " << t;
  }
  EXPECT_TRUE(pinched.any());
}

TEST(Pinches, ASharedVertexIsOne) {
  const Mesh mesh = shapes::cubes_at_vertex();
  expect_marks_at(mesh, {Vec3(1, 1, 1)});
}

TEST(Pinches, AnEdgeOfFourFacesIsOne) {
  const Mesh mesh = shapes::cubes_at_edge();
  const Topology topology =
      build_topology(mesh.triangles, static_cast<Index>(mesh.positions.size()));
  ASSERT_FALSE(topology.non_manifold_sides.empty());
  const Marks pinched = pinched_of(mesh);
  for (const SideId side : topology.non_manifold_sides)
    EXPECT_TRUE(pinched.test(triangle_of(side)));
  EXPECT_LT(pinched.count(), mesh.triangles.size());
}

}  // namespace
}  // namespace kdm
