// SPDX-License-Identifier: MIT
// Sides are bucketed by their lower corner; the short buckets are sorted by the upper one.
#include "mesh/topology.h"

#include <algorithm>
#include <numeric>

#include "mesh/disjoint_sets.h"

namespace kdm {
namespace {

struct SideRecord {
  Index upper;  // corner with the higher number
  Index side;
  bool forward;  // runs from the lower to the upper corner
};

// All sides along one edge.
void close_edge(std::span<const SideRecord> edge, Topology& topology, DisjointSets& parts) {
  Index forward = 0;
  for (const SideRecord& r : edge) {
    forward += r.forward ? 1 : 0;
    parts.join(edge[0].side / 3, r.side / 3);
  }
  topology.boundary_edges += edge.size() == 1 ? 1 : 0;
  topology.non_manifold_edges += edge.size() >= 3 ? 1 : 0;
  if (2 * forward != edge.size()) {
    ++topology.unbalanced_edges;
    for (const SideRecord& r : edge) {
      topology.first_unbalanced = std::min(topology.first_unbalanced, r.side);
    }
  }
  // The k-th side that runs forward meets the k-th that runs backward.
  std::size_t back = 0;
  for (const SideRecord& r : edge) {
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
  std::vector<Index> bucket(static_cast<std::size_t>(points) + 1, 0);
  for (const Triangle& t : triangles) {
    for (int i = 0; i < 3; ++i) ++bucket[std::min(t[i], t[next_corner(i)]) + 1];
  }
  std::partial_sum(bucket.begin(), bucket.end(), bucket.begin());
  std::vector<SideRecord> records(3 * triangles.size());
  std::vector<Index> fill(bucket.begin(), bucket.end() - 1);
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    for (int i = 0; i < 3; ++i) {
      const Index from = triangles[t][i];
      const Index to = triangles[t][next_corner(i)];
      records[fill[std::min(from, to)]++] = {std::max(from, to), static_cast<Index>(3 * t + i),
                                             from < to};
    }
  }
  DisjointSets parts(triangles.size());
  for (Index p = 0; p < points; ++p) {
    const auto begin = records.begin() + bucket[p];
    const auto end = records.begin() + bucket[p + 1];
    std::sort(begin, end, [](const SideRecord& a, const SideRecord& b) {
      return a.upper != b.upper ? a.upper < b.upper : a.side < b.side;
    });
    for (auto first = begin; first != end;) {
      auto last = first;
      while (last != end && last->upper == first->upper) ++last;
      if (first->upper != p) {
        close_edge({&*first, static_cast<std::size_t>(last - first)}, topology, parts);
      }
      first = last;
    }
  }
  topology.components = parts.count();
  return topology;
}

}  // namespace kdm
