// SPDX-License-Identifier: MIT
// Walks along unused edges, and cuts off a loop whenever the walk meets itself.
#include "mesh/boundary_loops.h"

#include <tuple>

#include "mesh/marks.h"
#include "mesh/sort.h"

namespace kdm {
namespace {

// One end of a boundary edge. The ends in one fan follow each other in the sorted list and are a
// node of the walk.
struct End {
  Index fan;
  Index edge;
  bool last;  // the edge runs towards this end, not away from it
};

class LoopFinder {
 public:
  explicit LoopFinder(std::span<const BoundaryEdge> edges)
      : edges_(edges), used_(edges.size()), nodes_(edges.size()) {
    for (Index i = 0; i < edges.size(); ++i) {
      ends_.push_back({edges[i].fans[0], i, false});
      ends_.push_back({edges[i].fans[1], i, true});
    }
    // Edges that go on in their own direction come first.
    sort_by(ends_, [](const End& a, const End& b) {
      return std::tie(a.fan, a.last, a.edge) < std::tie(b.fan, b.last, b.edge);
    });
    for (Index i = 0; i < ends_.size(); ++i) {
      if (i == 0 || ends_[i].fan != ends_[i - 1].fan) next_end_.push_back(i);
      nodes_[ends_[i].edge][ends_[i].last] = static_cast<Index>(next_end_.size() - 1);
    }
    end_of_node_.assign(next_end_.begin() + (next_end_.empty() ? 0 : 1), next_end_.end());
    end_of_node_.push_back(static_cast<Index>(ends_.size()));
    step_from_.assign(next_end_.size(), kNone);
  }

  std::vector<BoundaryLoop> run() {
    for (Index edge = 0; edge < edges_.size(); ++edge) {
      if (!used_.test(edge)) walk(edge);
    }
    return std::move(loops_);
  }

 private:
  struct Step {
    Index edge;
    Index node;      // where the step starts
    bool backwards;  // the step goes along its edge against the face's direction
  };

  void walk(Index edge) {
    bool backwards = false;
    for (;;) {
      const Index node = nodes_[edge][backwards];
      step_from_[node] = static_cast<Index>(path_.size());
      path_.push_back({edge, node, backwards});
      used_.set(edge);
      const Index reached = nodes_[edge][!backwards];
      if (step_from_[reached] != kNone) cut_off(step_from_[reached]);
      const End* next = next_unused(reached);
      if (next == nullptr) break;
      edge = next->edge;
      backwards = next->last;
    }
    for (const Step& step : path_) step_from_[step.node] = kNone;
    path_.clear();
  }

  // Takes the steps from this one on off the path: they are a loop.
  void cut_off(Index first) {
    BoundaryLoop loop;
    loop.face = edges_[path_[first].edge].face;
    for (std::size_t i = first; i < path_.size(); ++i) {
      loop.vertices.push_back(edges_[path_[i].edge].vertices[path_[i].backwards]);
      step_from_[path_[i].node] = kNone;
    }
    path_.resize(first);
    loops_.push_back(std::move(loop));
  }

  const End* next_unused(Index node) {
    Index& next = next_end_[node];
    while (next != end_of_node_[node] && used_.test(ends_[next].edge)) ++next;
    return next == end_of_node_[node] ? nullptr : &ends_[next];
  }

  std::span<const BoundaryEdge> edges_;
  Marks used_;                               // edges that are part of the path, or were
  std::vector<std::array<Index, 2>> nodes_;  // of each edge's ends
  std::vector<End> ends_;
  std::vector<Index> next_end_;     // of each node: its first end that may be unused
  std::vector<Index> end_of_node_;  // past its last end
  std::vector<Index> step_from_;    // of each node: the step of the path that starts there
  std::vector<Step> path_;
  std::vector<BoundaryLoop> loops_;
};

}  // namespace

std::vector<BoundaryLoop> find_boundary_loops(std::span<const BoundaryEdge> edges) {
  return LoopFinder(edges).run();
}

std::vector<BoundaryLoop> find_rim_loops(std::span<const SideId> opposite) {
  std::vector<BoundaryEdge> edges;
  for (SideId side = 0; side < opposite.size(); ++side) {
    if (opposite[side] != kNone) continue;
    // Turn round the corner at the side's end until the surface ends there too.
    SideId next = next_side(side);
    while (opposite[next] != kNone) next = next_side(opposite[next]);
    // The fan at either end of the rim's side has one rim side that starts there. The number of
    // that side stands for the fan and for its vertex.
    edges.push_back({{side, next}, {side, next}, triangle_of(side)});
  }
  return find_boundary_loops(edges);
}

}  // namespace kdm
