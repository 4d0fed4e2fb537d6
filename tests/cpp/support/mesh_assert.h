// SPDX-License-Identifier: MIT
// The judge's verdict as a GoogleTest assertion; apart from mesh_check.h, which the benchmark and
// the fuzzers use without GoogleTest.
#pragma once

#include <gtest/gtest.h>

#include "support/mesh_check.h"

namespace kdm::check {

/// EXPECT_TRUE(is_two_manifold(mesh)): closed, oriented, strictly 2-manifold as an index mesh.
inline ::testing::AssertionResult is_two_manifold(const Mesh& mesh) {
  const MeshCheck result = check_mesh(mesh);
  if (result.two_manifold) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure()
         << (mesh.triangles.empty() && mesh.quads.empty() ? "the mesh is empty" : result.faults());
}

/// The same with a boundary allowed: one or two faces an edge, one fan or half-fan a vertex.
inline ::testing::AssertionResult is_manifold(const Mesh& mesh) {
  const MeshCheck result = check_mesh(mesh);
  if (result.manifold) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure()
         << (mesh.triangles.empty() && mesh.quads.empty() ? "the mesh is empty" : result.faults());
}

}  // namespace kdm::check
