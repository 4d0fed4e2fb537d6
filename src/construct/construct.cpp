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
#include "construct/cell_border.h"
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

// What a cell hands down.
struct CellFrame : CellBorder {
  CellId cell = 0;
  int depth = 0;
  LatticeBox box;
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
               InsideModel& model, const CellMemory& memory, const Progress& progress,
               GridData& grid)
      : surface_(surface),
        model_(model),
        memory_(memory),
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
    if (memory_.notes != nullptr) *memory_.notes = {};
  }

  // Makes the cells. Returns the fraction of them that was made before the budget was exceeded; 1
  // if all were.
  double make_cells() {
    CellFrame root;
    root.triangles = lists_.all();
    root.several_solids = solids_.exist();
    root.rule = rule_->root();
    const FormerCell former;
    split_cell(root, memory_.former != nullptr && rule_->is_local() ? &former : nullptr);
    if (!budget_.sufficed()) return budget_.done();
    if (memory_.notes != nullptr) memory_.notes->complete = rule_->is_local();
    rule_->report(grid_.stats);
    model_.report(grid_.stats);
    grid_.cells.shrink_to_fit();
    return 1;
  }

  const EdgeCrossings& crossings() const { return crossings_; }
  EdgeCrossings take_crossings() { return std::move(crossings_); }

 private:
  // `former` is the same cell in the former construction; null: it had none.
  void split_cell(CellFrame& frame, const FormerCell* former) {
    if (budget_.exceeded(model_.work(), frame.done_before)) return;
    progress_.count_cell(frame.done_before);
    SplitNote note;
    note.several_solids = frame.several_solids;
    if (memory_.notes != nullptr) note.solids = solids_.bits_of(lists_.entries(frame.triangles));
    if (former != nullptr && former_cells().cells[former->cell].leaf()) former = nullptr;
    if (former != nullptr && take_over(frame, note, *former)) return;
    if (frame.several_solids) {
      frame.several_solids = solids_.leave_out(frame.state[0], lists_, frame.triangles);
    }
    if (frame.triangles.size() == 0) return;
    const std::optional<Split> split = choose(frame);
    if (!split) return;
    budget_.take_split();
    KDM_ASSERT(split->value > frame.box.lo[split->axis] && split->value < frame.box.hi[split->axis],
               "a split lies strictly inside its cell");
    const auto first_child = static_cast<CellId>(grid_.cells.size());
    grid_.cells[frame.cell] = Cell(first_child, split->axis, split->value);
    grid_.cells.resize(grid_.cells.size() + 2);
    const SplitId number = begin_note(note);
    Halves halves = divide(frame, *split, first_child);
    std::array<FormerCell, 2> formers;
    const bool as_before =
        former != nullptr && split_as(former_cells().cells[former->cell], *split);
    if (as_before) formers = halves_of(*former, former_cells());
    // The list of the upper child lies on top in the arena, but the lower child comes first in
    // depth-first order; its descendants' lists go above both.
    split_cell(halves.below, as_before ? &formers[0] : nullptr);
    split_cell(halves.above, as_before ? &formers[1] : nullptr);
    lists_.release(halves.below.triangles);
    end_note(number);
  }

  std::optional<Split> choose(const CellFrame& frame) {
    const Index unresolved = rule_->tally().unresolved;
    std::optional<Split> split =
        rule_->choose({frame.box, frame.depth, lists_.entries(frame.triangles), frame.rule,
                       frame.edges, crossings_.all, frame.state[0]});
    if (memory_.notes != nullptr && rule_->tally().unresolved > unresolved) {
      memory_.notes->unresolved.push_back(centre_of(frame.box));
    }
    if (!split && frame.depth < depth_ && model_.must_split(frame.box)) {
      split = halve_longest(frame.box);
    }
    return split;
  }

  const FormerCells& former_cells() const { return *memory_.former; }

  static bool split_as(const Cell& cell, const Split& split) {
    return cell.axis() == split.axis && cell.value() == split.value;
  }

  // Takes what is in a cell over from the former construction, if it would come out the same.
  bool take_over(const CellFrame& frame, const SplitNote& now, const FormerCell& former) {
    const FormerCells& before = former_cells();
    const SplitId first = before.cells[former.cell].split();
    const SplitNote& note = before.splits[first];
    if (now.solids != note.solids || now.several_solids != note.several_solids) return false;
    if ((now.solids & memory_.moved) != 0) return false;
    if (!same_border(frame, crossings_.all, former, before.crossings.all, surface_,
                     memory_.moved)) {
      return false;
    }
    const std::span<const Vec3> unresolved(before.unresolved.data() + note.unresolved_begin,
                                           note.unresolved_end - note.unresolved_begin);
    if (!rule_->has_budget(note.fine_splits) || !budget_.take_splits(note.end - first)) {
      return false;
    }
    rule_->count_cells(note.fine_splits, unresolved);
    copy_splits(before, former.cell, frame.cell, grid_.cells, crossings_, *memory_.notes);
    return true;
  }

  SplitId begin_note(SplitNote note) {
    const auto number = static_cast<SplitId>(grid_.cells.size() / 2 - 1);
    if (memory_.notes == nullptr) return number;
    note.fine_splits = rule_->tally().fine_splits;
    note.unresolved_begin = static_cast<Index>(memory_.notes->unresolved.size());
    memory_.notes->splits.push_back(note);
    return number;
  }

  void end_note(SplitId number) {
    if (memory_.notes == nullptr) return;
    SplitNote& note = memory_.notes->splits[number];
    note.end = static_cast<SplitId>(grid_.cells.size() / 2);
    note.fine_splits = rule_->tally().fine_splits - note.fine_splits;
    note.unresolved_end = static_cast<Index>(memory_.notes->unresolved.size());
  }

  Halves divide(const CellFrame& frame, const Split& split, CellId first_child) {
    Halves halves{frame, frame};
    cut_edges(
        split, crossings_.all,
        [&](bool high_next, bool high_previous, int counted) {
          return model_.state_at(
              corner_on_plane(frame.box, split.axis, split.value, high_next, high_previous),
              counted);
        },
        halves.below, halves.above);
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
      hand_down_edge(split.axis, i, range, halves.below, halves.above);
    }
  }

  const Surface& surface_;
  InsideModel& model_;
  const CellMemory& memory_;
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
                                 CellMemory memory, const Progress& progress, GridData& grid) {
  double shown = 0;
  Progress onwards;
  if (progress) {
    onwards = [&](double fraction, std::string_view phase) {
      shown = std::max(shown, fraction);  // another attempt starts where the last one stopped
      return progress(shown, phase);
    };
  }
  for (;;) {
    Construction construction(surface, options, tolerance, depth, model, memory, onwards, grid);
    const double done = construction.make_cells();
    if (done == 1) {
      if (memory.notes != nullptr) memory.notes->cells = grid.cells;
      ConstructedCells made{tolerance, make_hits(construction.crossings(), surface, model, grid)};
      if (memory.notes != nullptr) memory.notes->crossings = construction.take_crossings();
      return made;
    }
    tolerance = widening_for(done) * std::max(tolerance, 1.0);
    memory = {};
  }
}

}  // namespace kdm
