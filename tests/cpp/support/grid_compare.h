// SPDX-License-Identifier: MIT
// Compares grids, and the meshes that are extracted from them.
#pragma once

#include <gtest/gtest.h>

#include <cstring>

#include "grid/grid_data.h"
#include "kdmanifold/extract.h"
#include "support/extract_any.h"

namespace kdm::check {

/// Expects two grids to be equal in all their data.
inline void expect_same(const Grid& a, const Grid& b) {
  const GridData& x = a.data();
  const GridData& y = b.data();
  EXPECT_EQ(x.lattice.origin, y.lattice.origin);
  EXPECT_EQ(x.lattice.step, y.lattice.step);
  EXPECT_EQ(x.tolerance, y.tolerance);
  ASSERT_EQ(x.cells.size(), y.cells.size());
  EXPECT_EQ(std::memcmp(x.cells.data(), y.cells.data(), x.cells.size() * sizeof(Cell)), 0);
  EXPECT_EQ(x.edge_begin, y.edge_begin);
  EXPECT_EQ(x.opposite, y.opposite);
  EXPECT_EQ(x.start, y.start);
  ASSERT_EQ(x.hits.size(), y.hits.size());
  for (std::size_t h = 0; h < x.hits.size(); ++h) {
    EXPECT_EQ(x.hits[h].position, y.hits[h].position);
    EXPECT_EQ(x.hits[h].packed, y.hits[h].packed);
  }
  ASSERT_EQ(x.planes.size(), y.planes.size());
  for (std::size_t p = 0; p < x.planes.size(); ++p) {
    EXPECT_EQ(x.planes[p].normal, y.planes[p].normal);
    EXPECT_EQ(x.planes[p].offset, y.planes[p].offset);
  }
  EXPECT_EQ(x.source_faces, y.source_faces);
  EXPECT_EQ(x.source_operands, y.source_operands);
  EXPECT_EQ(x.exact.positions, y.exact.positions);
  EXPECT_EQ(x.exact.triangles, y.exact.triangles);
  EXPECT_EQ(x.exact.source_faces, y.exact.source_faces);
  EXPECT_EQ(x.exact.source_operands, y.exact.source_operands);
  EXPECT_EQ(x.sheet, y.sheet);
  ASSERT_EQ(x.rims.size(), y.rims.size());
  for (std::size_t r = 0; r < x.rims.size(); ++r) {
    EXPECT_EQ(x.rims[r].half_edge, y.rims[r].half_edge);
    EXPECT_EQ(x.rims[r].point, y.rims[r].point);
    EXPECT_EQ(x.rims[r].normal, y.rims[r].normal);
  }
  ASSERT_EQ(x.corners.size(), y.corners.size());
  for (std::size_t c = 0; c < x.corners.size(); ++c) {
    EXPECT_EQ(x.corners[c].half_edge, y.corners[c].half_edge);
    EXPECT_EQ(x.corners[c].point, y.corners[c].point);
  }
  EXPECT_EQ(x.stats.cells, y.stats.cells);
  EXPECT_EQ(x.stats.leaves, y.stats.leaves);
  EXPECT_EQ(x.stats.hits, y.stats.hits);
  EXPECT_EQ(x.stats.depth, y.stats.depth);
  EXPECT_EQ(x.stats.topology_resolved, y.stats.topology_resolved);
  EXPECT_EQ(x.stats.unresolved_leaves, y.stats.unresolved_leaves);
  EXPECT_EQ(x.stats.ambiguous_faces, y.stats.ambiguous_faces);
  EXPECT_EQ(x.stats.guessed_faces, y.stats.guessed_faces);
  EXPECT_EQ(x.input.vertices, y.input.vertices);
  EXPECT_EQ(x.input.triangles, y.input.triangles);
  EXPECT_EQ(x.input.closed, y.input.closed);
  EXPECT_EQ(x.input.boundary_edges, y.input.boundary_edges);
  EXPECT_EQ(x.input.boundary_loops, y.input.boundary_loops);
  EXPECT_EQ(x.input.non_manifold_edges, y.input.non_manifold_edges);
  EXPECT_EQ(x.input.degenerate_faces, y.input.degenerate_faces);
  EXPECT_EQ(x.input.cancelled_faces, y.input.cancelled_faces);
  EXPECT_EQ(x.input.components, y.input.components);
  EXPECT_EQ(x.input.flipped, y.input.flipped);
  EXPECT_EQ(x.input.lattice_step, y.input.lattice_step);
}

/// Expects equal meshes to be extracted from two grids.
inline void expect_same_surface(const Grid& a, const Grid& b) {
  for (const bool quads : {false, true}) {
    const ExtractedMesh x = extract_any(a, {.quads = quads, .normals = true});
    const ExtractedMesh y = extract_any(b, {.quads = quads, .normals = true});
    EXPECT_EQ(x.positions, y.positions);
    EXPECT_EQ(x.triangles, y.triangles);
    EXPECT_EQ(x.quads, y.quads);
    EXPECT_EQ(x.source_faces, y.source_faces);
    EXPECT_EQ(x.corner_normals, y.corner_normals);
    EXPECT_EQ(x.report.boundary_loops, y.report.boundary_loops);
  }
}

}  // namespace kdm::check
