// SPDX-License-Identifier: MIT
// Pairs sides edge by edge.
#include "mesh/topology.h"

#include <algorithm>

#include "mesh/disjoint_sets.h"
#include "mesh/edge_sides.h"

namespace kdm {
namespace {

// All sides along one edge.
void close_edge(std::span<const EdgeSide> edge, Topology& topology, DisjointSets& parts) {
  Index forward = 0;
  for (const EdgeSide& r : edge) {
    forward += r.forward ? 1 : 0;
    parts.join(edge[0].side / 3, r.side / 3);
  }
  topology.boundary_edges += edge.size() == 1 ? 1 : 0;
  topology.non_manifold_edges += edge.size() >= 3 ? 1 : 0;
  if (2 * forward != edge.size()) {
    ++topology.unbalanced_edges;
    for (const EdgeSide& r : edge) {
      topology.first_unbalanced = std::min(topology.first_unbalanced, r.side);
    }
  }
  // The k-th side that runs forward meets the k-th that runs backward.
  std::size_t back = 0;
  for (const EdgeSide& r : edge) {
    if (!r.forward) continue;
    while (back < edge.size() && edge[back].forward) ++back;
    if (back == edge.size()) return;
    topology.twin[r.side] = edge[back].side;
    topology.twin[edge[back].side] = r.side;
    ++back;
  }
}

}  // namespace

Topology build_topology(std::span<const Triangle> triangles, Index points) {
  Topology topology;
  topology.twin.assign(3 * triangles.size(), kNone);
  DisjointSets parts(triangles.size());
  EdgeSides(triangles, points).for_each_edge([&](Index, std::span<const EdgeSide> edge) {
    close_edge(edge, topology, parts);
  });
  topology.components = parts.count();
  return topology;
}

}  // namespace kdm
