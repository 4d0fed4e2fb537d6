// SPDX-License-Identifier: MIT
// The judge's verdict as a GoogleTest assertion. It stands apart from mesh_check.h, which the
// benchmark and the fuzzers use without GoogleTest.
#pragma once

#include <gtest/gtest.h>

#include <concepts>

#include "support/mesh_check.h"

namespace kdm::check {

/// Use as EXPECT_TRUE(is_two_manifold(mesh)): the mesh must be closed, oriented and strictly
/// 2-manifold as an index mesh.
template <std::derived_from<Mesh> Checked>
::testing::AssertionResult is_two_manifold(const Checked& mesh) {
  const MeshCheck result = check_mesh(mesh);
  if (result.two_manifold) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure()
         << (mesh.triangles.empty() && mesh.quads.empty() ? "the mesh is empty" : result.faults());
}

/// Use as EXPECT_TRUE(is_manifold(mesh)): the mesh may have a boundary besides. An edge has one or
/// two faces, and the faces at a vertex form one ring or one fan.
template <std::derived_from<Mesh> Checked>
::testing::AssertionResult is_manifold(const Checked& mesh) {
  const MeshCheck result = check_mesh(mesh);
  if (result.manifold) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure()
         << (mesh.triangles.empty() && mesh.quads.empty() ? "the mesh is empty" : result.faults());
}

}  // namespace kdm::check
