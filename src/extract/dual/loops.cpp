// SPDX-License-Identifier: MIT
// Makes the dual mesh of a grid, drops pillows, and finds the loops of half-edges.
#include "extract/dual/dual_mesh.h"
#include "geometry/assert.h"
#include "grid/pillows.h"

namespace kdm {
HalfEdgeId DualMesh::add_triangle(HitId of_hit, VertexId a, VertexId b, VertexId c) {
  const auto half_edge = static_cast<HalfEdgeId>(vertex.size());
  vertex.insert(vertex.end(), {a, b, c});
  opposite.insert(opposite.end(), 3, kNone);
  hit.push_back(of_hit);
  strip.push_back(0);
  return half_edge;
}

void DualMesh::set_first_half_edge(VertexId v, HalfEdgeId half_edge) {
  first_half_edge[v] = half_edge;
  if (!open) return;
  for (HalfEdgeId h = half_edge;;) {
    const HalfEdgeId behind = opposite[previous_in_triangle(h)];
    if (behind == half_edge) return;  // a ring
    if (behind == kNone) {
      first_half_edge[v] = h;
      return;
    }
    h = behind;
  }
}

DualMesh dual_mesh_of(const GridData& grid) {
  DualMesh mesh;
  const auto triangles = static_cast<Index>(grid.hits.size());
  mesh.opposite.resize(3 * grid.hits.size());
  mesh.vertex.assign(3 * grid.hits.size(), 0);
  mesh.hit.resize(triangles);
  mesh.strip.assign(triangles, 0);
  for (Index t = 0; t < triangles; ++t) {
    mesh.hit[t] = t;
    const bool reversed = grid.hits[t].reversed();
    for (Index slot = 0; slot < 3; ++slot) {
      const Index place = place_of_slot(slot, reversed);
      const Index other = grid.opposite[3 * t + slot];
      KDM_ASSERT(other != kNone || grid.sheet, "every half-edge of a solid is linked");
      if (other == kNone) {
        mesh.opposite[3 * t + place] = kNone;
        mesh.open = true;
      } else {
        const Index other_hit = other / 3;
        mesh.opposite[3 * t + place] =
            3 * other_hit + place_of_slot(other % 3, grid.hits[other_hit].reversed());
      }
      mesh.vertex[3 * t + place] = grid.start_leaf(3 * t + slot);
      if (grid.crosses_strip(3 * t + slot)) {
        mesh.strip[t] = static_cast<char>(mesh.strip[t] | 1 << place);
      }
    }
  }
  return mesh;
}

Index drop_pillows(DualMesh& mesh) {
  Index dropped = 0;
  const auto crosses_strip = [&](HalfEdgeId h) { return (mesh.strip[h / 3] >> h % 3 & 1) != 0; };
  PillowFinder(mesh.opposite, crosses_strip).for_each([&](const auto& triangles) {
    for (const Index t : triangles) {
      for (Index i = 0; i < 3; ++i) mesh.vertex[3 * t + i] = kNone;
    }
    ++dropped;
  });
  return dropped;
}

void find_loops(const GridData& grid, DualMesh& mesh) {
  // `vertex` holds leaves until a loop overwrites them with its number, marked by the top bit.
  constexpr Index kFound = 1u << 31;
  KDM_ASSERT(grid.cells.size() < kFound, "cell numbers leave a bit free");
  static_cast<void>(grid);
  mesh.first_half_edge.reserve(mesh.opposite.size() / 6);
  mesh.leaf.reserve(mesh.opposite.size() / 6);
  for (Index start = 0; start < mesh.opposite.size(); ++start) {
    if (mesh.vertex[start] & kFound) continue;  // found, or dropped
    const Index leaf = mesh.vertex[start];
    const Index loop = mesh.vertices() | kFound;
    mesh.first_half_edge.push_back(start);
    mesh.leaf.push_back(leaf);
    if (mesh.open) mesh.set_first_half_edge(static_cast<Index>(mesh.vertices() - 1), start);
    for (const HalfEdgeId h : mesh.ring_from(mesh.first_half_edge.back())) {
      KDM_ASSERT(mesh.vertex[h] == leaf, "a loop stays in one leaf");
      mesh.vertex[h] = loop;
    }
  }
  for (Index& vertex : mesh.vertex) {
    if (vertex != kNone) vertex &= ~kFound;
  }
}

void find_loops_of_leaves(const GridData& grid, DualMesh& mesh) {
  mesh.next_loop_in_leaf.resize(mesh.vertices());
  std::vector<Index> last(grid.cells.size(), kNone);  // of each leaf
  for (Index v = 0; v < mesh.next_loop_in_leaf.size(); ++v) {
    Index& before = last[mesh.leaf[v]];
    mesh.next_loop_in_leaf[v] = before == kNone ? v : mesh.next_loop_in_leaf[before];
    if (before != kNone) mesh.next_loop_in_leaf[before] = v;
    before = v;
  }
}

}  // namespace kdm
