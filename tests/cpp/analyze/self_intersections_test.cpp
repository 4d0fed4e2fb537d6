// SPDX-License-Identifier: MIT
// Crossings of a mesh's faces: known counts, and all pairs by brute force.
#include <gtest/gtest.h>

#include <numeric>

#include "geometry/triangle_triangle.h"
#include "kdmanifold/error.h"
#include "kdmanifold/mesh.h"
#include "mesh/marks.h"
#include "support/random.h"
#include "support/random_meshes.h"
#include "support/shapes.h"

namespace kdm {
namespace {

SelfIntersections by_brute_force(const Mesh& mesh) {
  std::vector<Triangle> triangles = mesh.triangles;
  std::vector<Index> face_of(triangles.size());
  std::iota(face_of.begin(), face_of.end(), Index{0});
  for (Index i = 0; i < mesh.quads.size(); ++i) {
    const Quad& q = mesh.quads[i];
    triangles.push_back({q[0], q[1], q[2]});
    triangles.push_back({q[0], q[2], q[3]});
    face_of.insert(face_of.end(), 2, static_cast<Index>(mesh.triangles.size()) + i);
  }
  const auto corners = [&](Index t) {
    const Triangle& n = triangles[t];
    return std::array<Vec3, 3>{mesh.positions[n[0]], mesh.positions[n[1]], mesh.positions[n[2]]};
  };
  SelfIntersections found;
  Marks crossing(mesh.triangles.size() + mesh.quads.size());
  for (Index i = 0; i < triangles.size(); ++i) {
    for (Index j = 0; j < i; ++j) {
      if (face_of[i] == face_of[j]) continue;
      if (!TriangleCrossing<RealKernel>::test(corners(i), triangles[i], corners(j), triangles[j])) {
        continue;
      }
      ++found.pairs;
      crossing.set(face_of[i]);
      crossing.set(face_of[j]);
    }
  }
  for (Index i = 0; i < crossing.size(); ++i) {
    if (crossing.test(i)) found.faces.push_back(i);
  }
  return found;
}

TEST(SelfIntersections, SolidsHaveNone) {
  for (const Mesh& mesh :
       {shapes::cube(), shapes::icosphere(3), shapes::torus(), shapes::nested_spheres(),
        shapes::torus_chain(3), shapes::rotated(shapes::stairs(5), Vec3(1, 2, 3), 0.7)}) {
    const SelfIntersections found = find_self_intersections(mesh);
    EXPECT_EQ(found.pairs, 0u);
    EXPECT_TRUE(found.faces.empty());
  }
}

TEST(SelfIntersections, ASpikeThroughATriangle) {
  Mesh mesh;
  mesh.positions = {Vec3(0, 0, 0), Vec3(4, 0, 0),  Vec3(0, 4, 0),
                    Vec3(1, 1, 1), Vec3(1, 1, -1), Vec3(9, 9, 0)};
  mesh.triangles = {{0, 1, 2}, {3, 4, 5}};
  const SelfIntersections found = find_self_intersections(mesh);
  EXPECT_EQ(found.pairs, 1u);
  EXPECT_EQ(found.faces, (std::vector<Index>{0, 1}));
  mesh.positions[3] = mesh.positions[4] = Vec3(3, 3, 1);
  mesh.positions[4][2] = -1;
  EXPECT_EQ(find_self_intersections(mesh).pairs, 0u);
}

TEST(SelfIntersections, TheSameAsByBruteForce) {
  std::uint64_t pairs = 0;
  for (std::uint32_t seed = 0; seed < 10; ++seed) {
    for (const Mesh& mesh :
         {shapes::random_tetrahedra(12, seed), shapes::integer_tetrahedra(12, 3, seed),
          shapes::random_voxels(3, 0.4, seed), shapes::overlapping_cubes()}) {
      const SelfIntersections expected = by_brute_force(mesh);
      // Products of coordinates as small as these would be zero.
      const bool small = seed % 2 == 1;
      const SelfIntersections found =
          find_self_intersections(shapes::scaled(mesh, Vec3::Constant(small ? 0x1p-400 : 1)));
      ASSERT_EQ(found.pairs, expected.pairs);
      ASSERT_EQ(found.faces, expected.faces);
      pairs += found.pairs;
    }
  }
  EXPECT_GT(pairs, 1000u);
}

TEST(SelfIntersections, QuadsCountAsTwoTriangles) {
  Mesh mesh;
  mesh.positions = {Vec3(0, 0, 0), Vec3(4, 0, 0),  Vec3(4, 4, 0), Vec3(0, 4, 0),
                    Vec3(2, 2, 1), Vec3(2, 2, -1), Vec3(9, 2, 0)};
  mesh.triangles = {{4, 5, 6}};
  mesh.quads = {{0, 1, 2, 3}};
  const SelfIntersections found = find_self_intersections(mesh);
  EXPECT_EQ(found.faces, (std::vector<Index>{0, 1}));
  EXPECT_GE(found.pairs, 1u);
}

TEST(SelfIntersections, CopiesCountEach) {
  for (std::uint32_t seed = 0; seed < 10; ++seed) {
    Mesh mesh = shapes::random_tetrahedra(6, seed);
    check::Random random(seed);
    const auto below = [&](std::size_t limit) {
      return static_cast<Index>(random.below(static_cast<std::uint32_t>(limit)));
    };
    for (int i = 0; i < 12; ++i) {
      const Triangle t = mesh.triangles[below(mesh.triangles.size())];
      mesh.triangles.push_back(i % 2 == 0 ? Triangle{t[1], t[2], t[0]}
                                          : Triangle{t[0], t[2], t[1]});
    }
    // Also quads that are folded, or whose halves are the same triangle.
    for (int i = 0; i < 8; ++i) {
      const Triangle& t = mesh.triangles[below(mesh.triangles.size())];
      mesh.quads.push_back({t[0], t[1], t[2], below(mesh.positions.size())});
      mesh.quads.push_back(i % 2 == 0 ? mesh.quads.back() : Quad{t[0], t[1], t[2], t[1]});
    }
    const SelfIntersections expected = by_brute_force(mesh);
    const SelfIntersections found = find_self_intersections(mesh);
    ASSERT_EQ(found.pairs, expected.pairs);
    ASSERT_EQ(found.faces, expected.faces);
  }
}

TEST(SelfIntersections, AHundredThousandCopiesAreNoWork) {
  constexpr Index kCopies = 100'000;
  Mesh mesh = shapes::cube();
  mesh.triangles.assign(kCopies, mesh.triangles[0]);
  const SelfIntersections found = find_self_intersections(mesh);
  EXPECT_EQ(found.pairs, std::uint64_t{kCopies} * (kCopies - 1) / 2);
  EXPECT_EQ(found.faces.size(), kCopies);
}

TEST(SelfIntersections, FacesWithoutAreaTakeNoPart) {
  Mesh mesh = shapes::cube();
  mesh.triangles.push_back({0, 0, 1});
  mesh.positions.emplace_back(0.5, 0.5, -1);
  mesh.positions.emplace_back(0.5, 0.5, 0.5);
  mesh.positions.emplace_back(0.5, 0.5, 2);
  mesh.triangles.push_back({8, 9, 10});
  EXPECT_EQ(find_self_intersections(mesh).pairs, 0u);
  EXPECT_EQ(find_self_intersections(Mesh()).pairs, 0u);
}

TEST(SelfIntersections, AFaceOutOfRangeIsRefused) {
  Mesh mesh = shapes::cube();
  mesh.triangles.push_back({0, 1, 99});
  EXPECT_THROW(find_self_intersections(mesh), Error);
}

}  // namespace
}  // namespace kdm
