// SPDX-License-Identifier: MIT
// Several loops of one leaf, nested in it.
#include "extract/embed/nested_loops.h"

#include <gtest/gtest.h>

#include <map>

#include "kdmanifold/mesh.h"
#include "support/contours.h"
#include "support/dual_mesh_check.h"
#include "support/mesh_assert.h"

namespace kdm {
namespace {

// For every curve a double cone: a loop's vertex within the box and one of no loop outside.
struct Cones {
  explicit Cones(const check::Contours& input) {
    for (int i = 0; i < 3; ++i) {
      box.lo[i] = static_cast<std::int32_t>(input.lo[i]);
      box.hi[i] = static_cast<std::int32_t>(input.hi[i]);
    }
    for (std::size_t c = 0; c < input.curves.size(); ++c) {
      loops.push_back(add_vertex(0.5 * (input.lo + input.hi), 0));
    }
    const auto first_point = static_cast<Index>(mesh.position.size());
    for (const Vec3& p : input.points) add_vertex(p, kNone);
    for (std::size_t c = 0; c < input.curves.size(); ++c) {
      const Index outside = add_vertex(Vec3::Zero(), kNone);
      const Curve& curve = input.curves[c];
      for (std::size_t i = 0; i < curve.size(); ++i) {
        const Index a = first_point + curve[i];
        const Index b = first_point + curve[(i + 1) % curve.size()];
        inner.push_back(add_triangle(loops[c], a, b));
        add_triangle(outside, b, a);
      }
    }
    for (const auto& [ends, half_edge] : half_edges_) {
      mesh.opposite[half_edge] = half_edges_.at({ends.second, ends.first});
    }
  }

  Index add_vertex(const Vec3& position, Index leaf) {
    mesh.position.push_back(position);
    mesh.leaf.push_back(leaf);
    mesh.first_half_edge.push_back(kNone);
    return static_cast<Index>(mesh.vertices() - 1);
  }

  Index add_triangle(Index a, Index b, Index c) {
    const Index first = mesh.add_triangle(mesh.triangles(), a, b, c);
    const std::array<Index, 3> corners = {a, b, c};
    for (Index i = 0; i < 3; ++i) {
      mesh.first_half_edge[corners[i]] = first + i;
      half_edges_[{corners[i], corners[(i + 1) % 3]}] = first + i;
    }
    return first / 3;
  }

  // What lies within the box: the inner triangles of before and all new ones.
  Mesh within(Index before) const {
    Mesh result;
    result.positions = mesh.position;
    const auto add = [&](Index t) {
      result.triangles.push_back(
          {mesh.vertex[3 * t], mesh.vertex[3 * t + 1], mesh.vertex[3 * t + 2]});
    };
    for (const Index t : inner) add(t);
    for (Index t = before; t < mesh.triangles(); ++t) add(t);
    return result;
  }

  LatticeBox box;
  DualMesh mesh;
  EditLog log;
  std::vector<Index> loops;
  std::vector<Index> inner;

 private:
  std::map<std::pair<Index, Index>, Index> half_edges_;
};

TEST(NestedLoops, KeepsAllApart) {
  std::uint64_t before = 0;
  for (std::uint32_t seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE(seed);
    const check::Contours input = check::random_contours(2 + static_cast<int>(seed % 3), seed);
    Cones cones(input);
    check::expect_sound(cones.mesh);
    const Index triangles = cones.mesh.triangles();
    before += find_self_intersections(cones.within(triangles)).pairs;
    ASSERT_TRUE(nest_loops(cones.box, cones.loops, cones.mesh, cones.log));
    check::expect_sound(cones.mesh);
    const Mesh surface = cones.within(triangles);
    EXPECT_TRUE(check::is_manifold(surface));
    EXPECT_EQ(find_self_intersections(surface).pairs, 0u);
    const MeshReport shape = describe(surface);
    EXPECT_EQ(shape.components, input.curves.size());
    EXPECT_EQ(shape.euler_characteristic, static_cast<int>(input.curves.size())) << "disks";
    EXPECT_EQ(shape.boundary_edges, input.points.size()) << "the rings";
    for (const Vec3& p : cones.mesh.position) {
      if (p.isZero()) continue;  // outside
      EXPECT_TRUE((p.array() >= input.lo.array()).all() && (p.array() <= input.hi.array()).all());
    }
  }
  EXPECT_GT(before, 1000u);
}

TEST(NestedLoops, NeedsRoom) {
  check::Contours input = check::random_contours(2, 1);
  Cones cones(input);
  cones.box.hi[2] = cones.box.lo[2] + 8;
  const Index triangles = cones.mesh.triangles();
  EXPECT_FALSE(nest_loops(cones.box, cones.loops, cones.mesh, cones.log));
  EXPECT_EQ(cones.mesh.triangles(), triangles);
}

}  // namespace
}  // namespace kdm
