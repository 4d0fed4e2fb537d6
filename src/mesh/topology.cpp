// SPDX-License-Identifier: MIT
// Pairs sides edge by edge.
#include "mesh/topology.h"

#include <algorithm>
#include <numeric>

namespace kdm {
namespace {

class UnionFind {
 public:
  explicit UnionFind(std::size_t size) : parent_(size), sets_(static_cast<Index>(size)) {
    std::iota(parent_.begin(), parent_.end(), Index{0});
  }
  void unite(Index a, Index b) {
    a = find(a);
    b = find(b);
    if (a == b) return;
    parent_[std::max(a, b)] = std::min(a, b);
    --sets_;
  }
  Index sets() const { return sets_; }

 private:
  Index find(Index a) {
    while (parent_[a] != a) a = parent_[a] = parent_[parent_[a]];
    return a;
  }
  std::vector<Index> parent_;
  Index sets_;
};

// All sides along one edge.
void close_edge(std::span<const EdgeSide> edge, Topology& topology, UnionFind& parts) {
  Index forward = 0;
  for (const EdgeSide& r : edge) {
    forward += r.forward ? 1 : 0;
    parts.unite(edge[0].side / 3, r.side / 3);
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
  UnionFind parts(triangles.size());
  EdgeSides(triangles, points).for_each_edge([&](Index, std::span<const EdgeSide> edge) {
    close_edge(edge, topology, parts);
  });
  topology.components = parts.sets();
  return topology;
}

Index count_boundary_loops(std::span<const Index> twin) {
  std::vector<char> seen(twin.size(), 0);
  const auto next_side = [](Index side) { return side % 3 == 2 ? side - 2 : side + 1; };
  Index loops = 0;
  for (Index start = 0; start < twin.size(); ++start) {
    if (twin[start] != kNone || seen[start] != 0) continue;
    ++loops;
    Index side = start;
    do {
      seen[side] = 1;
      // Round the corner at the side's end, until the surface ends there too.
      side = next_side(side);
      while (twin[side] != kNone) side = next_side(twin[side]);
    } while (side != start);
  }
  return loops;
}

}  // namespace kdm
