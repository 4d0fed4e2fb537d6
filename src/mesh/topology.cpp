// SPDX-License-Identifier: MIT
// Pairs sides edge by edge.
#include "mesh/topology.h"

#include <algorithm>

#include "mesh/disjoint_sets.h"
#include "mesh/edge_sides.h"

namespace kdm {
namespace {

void pair(const EdgeSide& a, const EdgeSide& b, std::vector<Index>& twin) {
  twin[a.side] = b.side;
  twin[b.side] = a.side;
}

// The k-th side that runs forward meets the k-th that runs backward.
void pair_in_order(std::span<const EdgeSide> edge, std::vector<Index>& twin) {
  std::size_t back = 0;
  for (const EdgeSide& r : edge) {
    if (!r.forward) continue;
    while (back < edge.size() && edge[back].forward) ++back;
    if (back == edge.size()) return;
    pair(r, edge[back], twin);
    ++back;
  }
}

// One side, or more than two, or two that run the same way.
void close_odd_edge(std::span<const EdgeSide> edge, Topology& topology) {
  topology.boundary_edges += edge.size() == 1 ? 1 : 0;
  if (edge.size() >= 3) {
    ++topology.non_manifold_edges;
    for (const EdgeSide& r : edge) topology.crowded.push_back(r.side);
  }
  const auto forward =
      std::count_if(edge.begin(), edge.end(), [](const EdgeSide& r) { return r.forward; });
  if (2 * static_cast<std::size_t>(forward) != edge.size()) {
    ++topology.unbalanced_edges;
    for (const EdgeSide& r : edge) {
      topology.first_unbalanced = std::min(topology.first_unbalanced, r.side);
    }
  }
  pair_in_order(edge, topology.twin);
}

}  // namespace

Topology build_topology(std::span<const Triangle> triangles, Index points) {
  Topology topology;
  topology.twin.assign(3 * triangles.size(), kNone);
  DisjointSets parts(triangles.size());
  EdgeSides(triangles, points).for_each_edge([&](Index, std::span<const EdgeSide> edge) {
    for (std::size_t i = 1; i < edge.size(); ++i) parts.join(edge[0].side / 3, edge[i].side / 3);
    if (edge.size() == 2 && edge[0].forward != edge[1].forward) {
      pair(edge[0], edge[1], topology.twin);
    } else {
      close_odd_edge(edge, topology);
    }
  });
  topology.components = parts.count();
  return topology;
}

}  // namespace kdm
