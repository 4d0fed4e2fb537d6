// SPDX-License-Identifier: MIT
// The top-down construction of the cell tree and its hits (paper 5.1.1).
//
// A cell hands down its twelve edges, each a range of crossings on one ancestor's splitting edge,
// and the inside model's states at its corners. So the state at a new corner is looked up in a
// range of crossings, never searched for among triangles. All crossings are kept until the cells
// are complete; then the crossings that bound the solid become hits.
#include "construct/construct.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "construct/budget.h"
#include "construct/crossing_search.h"
#include "construct/solid_filter.h"
#include "geometry/assert.h"
#include "mesh/progress.h"
#include "split/split_rules.h"
#include "split/triangle_lists.h"

namespace kdm {
namespace {

// Reports progress now and then.
class CellProgress {
 public:
  explicit CellProgress(const Progress& progress) : progress_(progress) {}

  // To be called for every cell, with the fraction of the construction that is done before it.
  void count_cell(double fraction) {
    constexpr std::uint32_t kInterval = 4096;  // cells between two calls
    if (++cells_since_report_ < kInterval) return;
    cells_since_report_ = 0;
    report_progress(progress_, fraction, "build");
  }

 private:
  const Progress& progress_;
  std::uint32_t cells_since_report_ = 0;
};

// What a cell hands down. Corners are numbered by bits: 1 for x, 2 for y, 4 for z at the high end.
struct CellFrame {
  CellId cell = 0;
  int depth = 0;
  LatticeBox box;
  CellEdges edges;
  std::array<int, 8> state{};  // of the inside model at the corners
  ListRange triangles;
  bool several_solids = false;  // have triangles in the list
  RuleRange rule;
  double done_before = 0;  // fraction of the construction before and after this cell
  double done_after = 1;
};

// The two parts of a split cell.
struct Halves {
  CellFrame below;
  CellFrame above;
};

// Sets the members of both halves that follow from the split alone.
void divide_box(const CellFrame& frame, const Split& split, CellId first_child, Halves& halves) {
  halves.below.cell = first_child;
  halves.above.cell = first_child + 1;
  halves.below.depth = halves.above.depth = frame.depth + 1;
  halves.below.box.hi[split.axis] = split.value;
  halves.above.box.lo[split.axis] = split.value;
}

// Shares the cell's part of the progress by the triangles in its halves.
void divide_progress(const CellFrame& frame, Halves& halves) {
  const double below = halves.below.triangles.size();
  const double both = below + halves.above.triangles.size();
  halves.below.done_after = halves.above.done_before =
      frame.done_before + (frame.done_after - frame.done_before) * (both > 0 ? below / both : 0.5);
}

// Hands splitting edge `i` of a split along `axis` to both halves.
void hand_down_edge(int axis, int i, EdgeRange range, Halves& halves) {
  const int u = next_axis(axis);
  const int v = previous_axis(axis);
  // Edges 0 and 2 run along u, at the low and high end of v; 1 and 3 along v, at the high and low
  // end of u. For axis u the next axis is v and the previous one is `axis`.
  const bool high = i == 1 || i == 2;
  if (axis_of_edge(axis, i) == u) {
    halves.below.edges[cell_edge(u, high, true)] = range;
    halves.above.edges[cell_edge(u, high, false)] = range;
  } else {
    halves.below.edges[cell_edge(v, true, high)] = range;
    halves.above.edges[cell_edge(v, false, high)] = range;
  }
}

// Splits a box in the middle of its longest side; not one that has no middle.
std::optional<Split> halve_longest(const LatticeBox& box) {
  const int axis = longest_axis(box);
  if (extent(box, axis) < 2) return std::nullopt;
  return Split{axis, box.lo[axis] + extent(box, axis) / 2};
}

// One attempt to construct the cells.
class Construction {
 public:
  Construction(const Surface& surface, const BuildOptions& options, double tolerance, int depth,
               InsideModel& model, const Progress& progress, GridData& grid)
      : model_(model),
        grid_(grid),
        depth_(depth),
        rule_(make_split_rule(surface, model, options, tolerance, depth)),
        lists_(surface.triangles),
        search_(surface.triangles),
        solids_(surface, model),
        budget_(surface.repair || surface.patched
                    ? Budget::for_repair(surface.triangles.size(), model.work())
                    : Budget()),
        progress_(progress) {
    const std::size_t splits = 2 * surface.triangles.size();  // a guess
    grid.stats = {};
    grid.cells.assign(1, Cell());
    grid.cells.reserve(2 * splits);
    crossings_.edge_begin.reserve(4 * splits);
    crossings_.all.reserve(2 * splits);
  }

  // Makes the cells. Returns the fraction of them that was made before the budget was exceeded; 1
  // if all were.
  double make_cells() {
    CellFrame root;
    root.triangles = lists_.all();
    root.several_solids = solids_.exist();
    root.rule = rule_->root();
    split_cell(root);
    if (!budget_.sufficed()) return budget_.done();
    rule_->report(grid_.stats);
    model_.report(grid_.stats);
    grid_.cells.shrink_to_fit();
    return 1;
  }

  const EdgeCrossings& crossings() const { return crossings_; }

 private:
  void split_cell(CellFrame& frame) {
    if (budget_.exceeded(model_.work(), frame.done_before)) return;
    progress_.count_cell(frame.done_before);
    if (frame.several_solids) {
      frame.several_solids = solids_.leave_out(frame.state[0], lists_, frame.triangles);
    }
    if (frame.triangles.size() == 0) return;
    std::optional<Split> split =
        rule_->choose({frame.box, frame.depth, lists_.entries(frame.triangles), frame.rule,
                       frame.edges, crossings_.all, frame.state[0]});
    if (!split && frame.depth < depth_ && model_.must_split(frame.box)) {
      split = halve_longest(frame.box);
    }
    if (!split) return;
    budget_.take_split();
    KDM_ASSERT(split->value > frame.box.lo[split->axis] && split->value < frame.box.hi[split->axis],
               "a split lies strictly inside its cell");
    const auto first_child = static_cast<CellId>(grid_.cells.size());
    grid_.cells[frame.cell] = Cell(first_child, split->axis, split->value);
    grid_.cells.resize(grid_.cells.size() + 2);
    Halves halves = divide(frame, *split, first_child);
    // The list of the upper child lies on top in the arena, but the lower child comes first in
    // depth-first order; its descendants' lists go above both.
    split_cell(halves.below);
    split_cell(halves.above);
    lists_.release(halves.below.triangles);
  }

  Halves divide(const CellFrame& frame, const Split& split, CellId first_child) {
    Halves halves{frame, frame};
    divide_edges(frame, split, halves);
    const TriangleLists::Children lists = lists_.divide(frame.triangles, split.axis, split.value);
    halves.below.triangles = lists.below;
    halves.above.triangles = lists.above;
    add_splitting_edges(frame.box, split, halves);
    const auto ranges = rule_->divide(frame.rule, split);
    halves.below.rule = ranges[0];
    halves.above.rule = ranges[1];
    divide_box(frame, split, first_child, halves);
    divide_progress(frame, halves);
    return halves;
  }

  // Cuts the four edges that run across the plane. The crossings on them lead from the states at
  // the cell's corners to those at the corners of the splitting face.
  void divide_edges(const CellFrame& frame, const Split& split, Halves& halves) {
    const int w = split.axis;
    for (int e = 0; e < 4; ++e) {
      const bool high_next = (e & 1) != 0;
      const bool high_previous = (e & 2) != 0;
      const EdgeRange whole = frame.edges[4 * w + e];
      Index cut = whole.begin;
      while (cut < whole.end && floor_of(crossings_.all[cut].position()) < split.value) ++cut;
      halves.below.edges[4 * w + e].end = cut;
      halves.above.edges[4 * w + e].begin = cut;
      const int low_corner =
          (high_next ? 1 << next_axis(w) : 0) | (high_previous ? 1 << previous_axis(w) : 0);
      const int high_corner = low_corner | 1 << w;
      const int counted =
          cut == whole.begin ? frame.state[low_corner] : crossings_.all[cut - 1].state_after();
      const int state = model_.state_at(
          corner_on_plane(frame.box, w, split.value, high_next, high_previous), counted);
      halves.below.state[high_corner] = state;
      halves.above.state[low_corner] = state;
    }
  }

  // Finds and classifies the crossings of the four new edges and hands the edges to both halves.
  void add_splitting_edges(const LatticeBox& box, const Split& split, Halves& halves) {
    search_.run(box, split, lists_);
    const int u = next_axis(split.axis);
    const int v = previous_axis(split.axis);
    // The corner of the upper half at the low end of each edge, and at the high end.
    const std::array<int, 4> low_corner{0, 1 << u, 1 << v, 0};
    const std::array<int, 4> high_corner{1 << u, 1 << u | 1 << v, 1 << u | 1 << v, 1 << v};
    for (int i = 0; i < 4; ++i) {
      const int axis = axis_of_edge(split.axis, i);
      EdgeRange range;
      range.begin = static_cast<Index>(crossings_.all.size());
      model_.plan_edge(
          {axis, corner_on_plane(box, split.axis, split.value, i == 1, i == 2), box.hi[axis],
           halves.above.state[low_corner[i]], halves.above.state[high_corner[i]]},
          search_.on_edge(i), crossings_.all);
      range.end = static_cast<Index>(crossings_.all.size());
      for (Index c = range.begin; c < range.end; ++c) {
        rule_->on_crossing(crossings_.all[c].triangle());
      }
      crossings_.edge_begin.push_back(range.end);
      hand_down_edge(split.axis, i, range, halves);
    }
  }

  InsideModel& model_;
  GridData& grid_;
  int depth_;  // that no cell goes beyond
  std::unique_ptr<SplitRule> rule_;
  TriangleLists lists_;
  CrossingSearch search_;
  SolidFilter solids_;
  EdgeCrossings crossings_;
  Budget budget_;
  CellProgress progress_;
};

// Makes hits of the crossings that bound the solid. Returns their triangles.
std::vector<TriangleId> make_hits(const EdgeCrossings& crossings, const Surface& surface,
                                  InsideModel& model, GridData& grid) {
  HitWriter writer(surface, crossings.all.size(), grid);
  model.finish_edges(crossings, writer);
  mark_active_sides(grid);
  return writer.finish();
}

// Returns how much wider a tolerance must be for all cells to be within the limits that a fraction
// `done` of them exhausted. Where triangles cross everywhere, the number of cells grows with about
// the power 2/3 of the tolerance's inverse.
double widening_for(double done) {
  const double part = std::max(done, 1e-3);
  return std::clamp(1 / (part * std::sqrt(part)), 1.5, 16.0);
}

}  // namespace

ConstructedCells construct_cells(const Surface& surface, InsideModel& model,
                                 const BuildOptions& options, double tolerance, int depth,
                                 const Progress& progress, GridData& grid) {
  double shown = 0;
  Progress onwards;
  if (progress) {
    onwards = [&](double fraction, std::string_view phase) {
      shown = std::max(shown, fraction);  // another attempt starts where the last one stopped
      return progress(shown, phase);
    };
  }
  for (;;) {
    Construction construction(surface, options, tolerance, depth, model, onwards, grid);
    const double done = construction.make_cells();
    if (done == 1) {
      return {tolerance, make_hits(construction.crossings(), surface, model, grid)};
    }
    tolerance = widening_for(done) * std::max(tolerance, 1.0);
  }
}

}  // namespace kdm
