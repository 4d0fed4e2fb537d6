// SPDX-License-Identifier: MIT
// Checks that a dual mesh is a sound half-edge structure.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>

#include "extract/dual/dual_mesh.h"

namespace kdm::check {

/// Expects links to be mutual and to run against each other, and the half-edges at each vertex to
/// be one ring, or one chain from boundary to boundary. Dropped triangles and vertices are left
/// out.
inline void expect_sound(const DualMesh& mesh) {
  ASSERT_EQ(mesh.vertex.size(), 3u * mesh.triangles());
  ASSERT_EQ(mesh.opposite.size(), mesh.vertex.size());
  ASSERT_EQ(mesh.position.size(), mesh.vertices());
  ASSERT_EQ(mesh.leaf.size(), mesh.vertices());
  std::size_t ring_sum = 0;
  for (Index v = 0; v < mesh.vertices(); ++v) {
    if (mesh.first_half_edge[v] == kNone) continue;
    Index half_edge = mesh.first_half_edge[v];
    do {
      ASSERT_EQ(mesh.vertex[half_edge], v);
      ++ring_sum;
      half_edge = mesh.next_in_ring(half_edge);
    } while (half_edge != mesh.first_half_edge[v] && half_edge != kNone);
    if (half_edge != kNone) continue;
    ASSERT_TRUE(mesh.open);
    ASSERT_NE(mesh.boundary_into(v), kNone) << "a chain starts at the boundary";
    ASSERT_EQ(mesh.vertex[next_in_triangle(mesh.boundary_into(v))], v);
  }
  const auto dropped = std::count(mesh.vertex.begin(), mesh.vertex.end(), kNone);
  EXPECT_EQ(ring_sum, mesh.vertex.size() - static_cast<std::size_t>(dropped));
  for (Index h = 0; h < mesh.opposite.size(); ++h) {
    if (mesh.opposite[h] == kNone || mesh.dropped(h / 3)) continue;
    ASSERT_EQ(mesh.opposite[mesh.opposite[h]], h);
    ASSERT_EQ(mesh.vertex[mesh.opposite[h]], mesh.vertex[next_in_triangle(h)]);
  }
}

}  // namespace kdm::check
