// SPDX-License-Identifier: MIT
// Open parts by themselves: what preparing them closes, what stays open, and a rough look at it.
#include "csg/open_parts.h"

#include <gtest/gtest.h>

#include <cmath>

#include "csg/rough_look.h"
#include "prepare/input_faces.h"
#include "support/mesh_check.h"
#include "support/random.h"
#include "support/shapes.h"

namespace kdm {
namespace {

Mesh square_of(double size, const Vec3& at, const Vec3& axis, double angle) {
  Mesh mesh;
  mesh.positions = {Vec3(0, 0, 0), Vec3(size, 0, 0), Vec3(size, size, 0), Vec3(0, size, 0)};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return shapes::translated(shapes::rotated(mesh, axis, angle), at);
}

// Squares that cross each other at random: a good part of the area, so that no part counts as a
// sheet that may be left out.
std::vector<Mesh> crossing_squares(int count) {
  check::Random random(3);
  std::vector<Mesh> parts;
  for (int i = 0; i < count; ++i) {
    parts.push_back(square_of(1, random.point(0, 1.5), random.point(-1, 1), random.between(0, 3)));
  }
  return parts;
}

TEST(OpenParts, AreToldFromClosedOnes) {
  const Mesh mesh = shapes::merged({shapes::cube(), square_of(1, Vec3(3, 0, 0), Vec3::UnitX(), 1),
                                    shapes::translated(shapes::cube(), Vec3(6, 0, 0))});
  InputFaces faces;
  faces.points = mesh.positions;
  faces.triangles = mesh.triangles;
  faces.source_faces.resize(mesh.triangles.size());
  for (Index t = 0; t < faces.source_faces.size(); ++t) faces.source_faces[t] = t;
  faces.topology = build_topology(faces.triangles, static_cast<Index>(faces.points.size()));
  const FaceParts parts = parts_of(faces);
  EXPECT_EQ(parts.open.size(), 3u);
  EXPECT_EQ(parts.open.count(), 1u);
  EXPECT_TRUE(parts.some_closed());
  const PartsMesh open = mesh_of_parts(faces, parts, true);
  EXPECT_EQ(open.mesh.source_faces, (std::vector<Index>{12, 13}));
  EXPECT_EQ(open.mesh.triangles.size(), 2u);
  EXPECT_EQ(mesh_of_parts(faces, parts, false).mesh.triangles.size(), 24u);
}

TEST(OpenParts, ThatCloseAreHandedOutClosed) {
  const BuildOptions options{.tolerance = 0.01};
  const OpenParts closed = prepare_by_themselves(shapes::open(shapes::cube(), 2), options);
  EXPECT_TRUE(closed.faces.triangles.empty());
  EXPECT_EQ(closed.done.patched_holes, 1u);
  EXPECT_NEAR(check::check_mesh(closed.closed).volume, 1, 1e-9);
  EXPECT_TRUE(check::check_mesh(closed.closed).closed);
  // Beside squares too large to be left out.
  std::vector<Mesh> parts = crossing_squares(8);
  parts.push_back(shapes::translated(shapes::cube(), Vec3(9, 0, 0)));
  const OpenParts both = prepare_by_themselves(shapes::merged(parts), options);
  EXPECT_EQ(both.closed.triangles.size(), 12u);
  EXPECT_EQ(both.faces.triangles.size(), 16u);
  EXPECT_TRUE(both.faces.repair);
}

TEST(OpenParts, ARoughLookIsRoughAndClosed) {
  const OpenParts rest =
      prepare_by_themselves(shapes::merged(crossing_squares(8)), {.tolerance = 0.02});
  ASSERT_EQ(rest.faces.triangles.size(), 16u);
  const Mesh rough = look_roughly(rest.faces, {.tolerance = 0.02}, {});
  const Mesh fine = look_roughly(rest.faces, {.tolerance = 0.005}, {});
  EXPECT_TRUE(check::check_mesh(rough).closed);
  EXPECT_LT(3 * rough.triangles.size(), 2 * fine.triangles.size());
}

}  // namespace
}  // namespace kdm
