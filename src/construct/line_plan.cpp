// SPDX-License-Identifier: MIT
#include "construct/line_plan.h"

#include <numeric>
#include <span>
#include <utility>

#include "inside/winding.h"
#include "mesh/progress.h"

namespace kdm {
namespace {

class LinePlanner {
 public:
  LinePlanner(const std::vector<LineCrossing>& crossings, const FinestTree& tree,
              InsideModel& model)
      : tree_(tree),
        cells_(tree.cells()),
        lines_(tree.cells()),
        model_(model),
        begin_(std::size_t{lines_.size()} + 1, 0),
        sorted_(crossings.size()) {
    for (const LineCrossing& c : crossings) ++begin_[c.line + 1];
    std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
    std::vector<Index> fill(begin_.begin(), begin_.end() - 1);
    for (const LineCrossing& c : crossings) sorted_[fill[c.line]++] = c.crossing;
  }

  LinePlan run(const Progress& progress) {
    constexpr Index kInterval = 4096;  // lines between two calls
    for (Index line = 0; line < lines_.size(); ++line) {
      if (line % kInterval == 0) {
        report_progress(progress, line / static_cast<double>(lines_.size()), "build");
      }
      if (begin_[line] != begin_[line + 1]) follow(line);
    }
    return std::move(plan_);
  }

 private:
  void follow(Index line) {
    const auto crossings =
        std::span(sorted_).subspan(begin_[line], begin_[line + 1] - begin_[line]);
    sort_crossings(crossings);
    TwinEdges edges;
    edges.axis = lines_.axis(line);
    edges.place = lines_.place(line);
    const int u = next_axis(edges.axis);
    const int v = previous_axis(edges.axis);
    const bool u_is_deeper = depth_of_plane(edges.place, u) > depth_of_plane(edges.place, v);
    edges.split_axis = u_is_deeper ? u : v;
    edges.side_axis = u_is_deeper ? v : u;
    const int depth = depth_of_plane(edges.place, edges.split_axis);
    const int bits = kLatticeBits - FinestCells::halvings(edges.axis, depth);  // an edge's length
    int state = 0;
    for (std::size_t first = 0; first < crossings.size();) {
      const std::int32_t edge = floor_of(crossings[first].position) >> bits;
      std::size_t last = first + 1;
      while (last < crossings.size() && floor_of(crossings[last].position) >> bits == edge) ++last;
      edges.place[edges.axis] = cells_.place(edges.axis, edge << bits);
      state = plan_edge(edges, bits, crossings.subspan(first, last - first), state);
      add_edges(edges, depth);
      first = last;
    }
  }

  int depth_of_plane(const LatticePoint& place, int axis) const {
    return cells_.depth_of_plane(axis, place[axis]);
  }

  // Keeps the crossings on a splitting edge that become hits. Returns the state at its upper end.
  int plan_edge(const TwinEdges& edges, int bits, std::span<const Crossing> crossings, int state) {
    GridEdge edge;
    edge.axis = edges.axis;
    for (int k = 0; k < 3; ++k) edge.low[k] = cells_.plane(k, edges.place[k]);
    edge.high = edge.low[edges.axis] + (1 << bits);
    edge.state_low = state;
    for (const Crossing& c : crossings) state = model_.state_after(state, c.triangle, c.leaving);
    edge.state_high = state;
    found_.assign(crossings.begin(), crossings.end());
    planned_.clear();
    model_.plan_edge(edge, found_, planned_);
    open_gaps(edges.axis);
    for (const ClassifiedCrossing& c : planned_) {
      if (c.kept()) plan_.crossings.push_back(c);
    }
    return state;
  }

  // Keeps the crossings at gaps between which a grid vertex lies (see inside/gaps.h). All cells
  // round a crossing are of the greatest depth, so there is a vertex between it and whatever lies
  // beyond these cells.
  void open_gaps(int axis) {
    for (Index c = 0; c < planned_.size(); ++c) {
      if (!begins_gap(planned_[c])) continue;
      ClassifiedCrossing& other = planned_[end_of_gap(planned_, c)];
      if (cells_.place(axis, floor_of(planned_[c].position())) ==
          cells_.place(axis, floor_of(other.position()))) {
        continue;
      }
      planned_[c].set_role(CrossingRole::kBounds);
      other.set_role(CrossingRole::kBounds);
    }
  }

  // Adds the edges to the plan if some of their crossings were kept.
  void add_edges(TwinEdges edges, int depth) {
    const auto kept = static_cast<Index>(plan_.crossings.size());
    if (kept == plan_.begin.back()) return;
    const auto edge_of = [&](const LatticePoint& place, bool high) {
      return edge_of_split(tree_.split(cells_.code(place), depth),
                           edge_on_side(edges.split_axis, edges.side_axis, high));
    };
    edges.above = edge_of(edges.place, false);
    LatticePoint below = edges.place;
    --below[edges.side_axis];
    edges.below = edge_of(below, true);
    plan_.edges.push_back(edges);
    plan_.begin.push_back(kept);
  }

  const FinestTree& tree_;
  const FinestCells& cells_;
  FinestLines lines_;
  InsideModel& model_;
  std::vector<Index> begin_;  // per line its first crossing in `sorted_`; last, their number
  std::vector<Crossing> sorted_;
  std::vector<Crossing> found_;
  std::vector<ClassifiedCrossing> planned_;
  LinePlan plan_;
};

}  // namespace

LinePlan plan_lines(const std::vector<LineCrossing>& crossings, const FinestTree& tree,
                    InsideModel& model, const Progress& progress) {
  return LinePlanner(crossings, tree, model).run(progress);
}

}  // namespace kdm
