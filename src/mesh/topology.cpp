// SPDX-License-Identifier: MIT
// Pairs the sides along each edge.
#include "mesh/topology.h"

#include <algorithm>

#include "mesh/edge_sides.h"
#include "mesh/joined.h"
#include "mesh/marks.h"

namespace kdm {
namespace {

void pair(const EdgeSide& a, const EdgeSide& b, std::vector<SideId>& opposite) {
  opposite[a.side] = b.side;
  opposite[b.side] = a.side;
}

// Pairs the k-th side that runs forward with the k-th that runs backward.
void pair_in_order(std::span<const EdgeSide> edge, std::vector<SideId>& opposite) {
  std::size_t back = 0;
  for (const EdgeSide& s : edge) {
    if (!s.forward) continue;
    while (back < edge.size() && edge[back].forward) ++back;
    if (back == edge.size()) return;
    pair(s, edge[back], opposite);
    ++back;
  }
}

// Counts and pairs the sides of an edge other than the usual one, which has two sides that run
// against each other.
void add_unusual_edge(std::span<const EdgeSide> edge, Topology& topology) {
  topology.boundary_edges += edge.size() == 1 ? 1 : 0;
  if (edge.size() >= 3) {
    ++topology.non_manifold_edges;
    for (const EdgeSide& s : edge) topology.non_manifold_sides.push_back(s.side);
  }
  const auto forward =
      std::count_if(edge.begin(), edge.end(), [](const EdgeSide& s) { return s.forward; });
  if (2 * static_cast<std::size_t>(forward) != edge.size()) {
    ++topology.unbalanced_edges;
    for (const EdgeSide& s : edge) {
      topology.first_unbalanced = std::min(topology.first_unbalanced, s.side);
    }
  }
  pair_in_order(edge, topology.opposite);
}

}  // namespace

Topology build_topology(std::span<const Triangle> triangles, Index points) {
  Topology topology;
  topology.opposite.assign(3 * triangles.size(), kNone);
  DisjointSets parts(triangles.size());
  EdgeSides(triangles, points).for_each_edge([&](PointId, std::span<const EdgeSide> edge) {
    for (std::size_t i = 1; i < edge.size(); ++i) {
      parts.join(triangle_of(edge[0].side), triangle_of(edge[i].side));
    }
    if (edge.size() == 2 && edge[0].forward != edge[1].forward) {
      pair(edge[0], edge[1], topology.opposite);
    } else {
      add_unusual_edge(edge, topology);
    }
  });
  topology.components = parts.count();
  return topology;
}

DisjointSets join_at_edges(std::span<const Triangle> triangles, Index points,
                           const Topology& topology) {
  DisjointSets sets = join_triangles(topology.opposite);
  Marks others(topology.opposite.size());  // sides that may share their edge with several sides
  for (const SideId side : topology.non_manifold_sides) others.set(side);
  for (SideId side = 0; side < others.size(); ++side) {
    if (topology.opposite[side] == kNone) others.set(side);
  }
  if (!others.any()) return sets;
  EdgeSides(triangles, points, others).for_each_edge([&](PointId, std::span<const EdgeSide> edge) {
    for (const EdgeSide& s : edge) sets.join(triangle_of(edge[0].side), triangle_of(s.side));
  });
  return sets;
}

std::vector<Index> find_parts(const Topology& topology) {
  if (topology.components <= 1 && topology.non_manifold_edges == 0) return {};
  DisjointSets parts = join_triangles(topology.opposite);
  if (parts.count() <= 1) return {};
  return number_sets(parts, topology.opposite.size() / 3);
}

}  // namespace kdm
