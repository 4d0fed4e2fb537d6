// SPDX-License-Identifier: MIT
#include "construct/cell_maker.h"

#include <utility>

#include "construct/cell_border.h"
#include "geometry/assert.h"

namespace kdm {
namespace {

// Splits a box in the middle of its longest side; not one that has no middle.
std::optional<Split> halve_longest(const LatticeBox& box) {
  const int axis = longest_axis(box);
  if (extent(box, axis) < 2) return std::nullopt;
  return Split{axis, box.lo[axis] + extent(box, axis) / 2};
}

bool split_as(const Cell& cell, const Split& split) {
  return cell.axis() == split.axis && cell.value() == split.value;
}

}  // namespace

CellMaker::CellMaker(const CellTask& task, const Budget& budget, TriangleLists lists)
    : task_(task),
      budget_(budget),
      lists_(std::move(lists)),
      search_(task.surface.triangles),
      solids_(task.surface, task.model),
      progress_(task.progress) {
  const std::size_t splits = 2 * std::size_t{lists_.all().size()};  // a guess
  made_.cells.assign(1, Cell());
  made_.cells.reserve(2 * splits);
  made_.crossings.edge_begin.reserve(4 * splits);
  made_.crossings.all.reserve(2 * splits);
}

CellMaker::CellMaker(const CellTask& task, const Budget& budget)
    : CellMaker(task, budget, TriangleLists(task.surface.triangles)) {
  root_.triangles = lists_.all();
  root_.several_solids = solids_.exist();
  root_.rule = task_.rule.root();
}

CellMaker::CellMaker(const CellTask& task, const Budget& budget, const Subtree& subtree)
    : CellMaker(task, budget, TriangleLists(task.surface.triangles, subtree.entries)) {
  root_ = subtree.frame;
  root_.cell = 0;
  root_.triangles = lists_.all();
  Index next = 0;
  for (EdgeRange& edge : root_.edges) {
    const Index size = edge.end - edge.begin;
    edge = {next, next + size};
    next += size;
  }
  made_.crossings.all = subtree.border;
  made_.crossings.edge_begin = {next};
}

void CellMaker::make_all() {
  const FormerCell former;
  split_cell(root_, task_.memory.former != nullptr && task_.rule.is_local() ? &former : nullptr);
}

std::vector<Subtree> CellMaker::make_top(Index most_triangles) {
  most_left_ = most_triangles;
  make_all();
  return std::move(left_);
}

// `former` is the same cell in the former construction; null: it had none.
void CellMaker::split_cell(CellFrame& frame, const FormerCell* former) {
  if (budget_.exceeded(task_.model.work(), frame.done_before)) return;
  if (frame.triangles.size() <= most_left_) return leave(frame);
  progress_.count_cell(frame.done_before);
  SplitNote note;
  note.several_solids = frame.several_solids;
  if (task_.memory.notes != nullptr) note.solids = solids_.bits_of(lists_.entries(frame.triangles));
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
  const auto first_child = static_cast<CellId>(made_.cells.size());
  made_.cells[frame.cell] = Cell(first_child, split->axis, split->value);
  made_.cells.resize(made_.cells.size() + 2);
  const SplitId number = begin_note(note);
  Halves halves = divide(frame, *split, first_child);
  std::array<FormerCell, 2> formers;
  const bool as_before = former != nullptr && split_as(former_cells().cells[former->cell], *split);
  if (as_before) formers = halves_of(*former, former_cells());
  // The list of the upper child lies on top in the arena, but the lower child comes first in
  // depth-first order; its descendants' lists go above both.
  split_cell(halves.below, as_before ? &formers[0] : nullptr);
  split_cell(halves.above, as_before ? &formers[1] : nullptr);
  lists_.release(halves.below.triangles);
  end_note(number);
}

// Keeps what it takes to go on with the cell later.
void CellMaker::leave(const CellFrame& frame) {
  if (frame.triangles.size() == 0) return;
  const std::span<const ListEntry> entries = lists_.entries(frame.triangles);
  Subtree& subtree = left_.emplace_back();
  subtree.frame = frame;
  subtree.entries.assign(entries.begin(), entries.end());
  for (const EdgeRange& edge : frame.edges) {
    subtree.border.insert(subtree.border.end(), made_.crossings.all.begin() + edge.begin,
                          made_.crossings.all.begin() + edge.end);
  }
  subtree.splits_before = made_.splits();
  subtree.unresolved_before = static_cast<Index>(made_.unresolved.size());
}

std::optional<Split> CellMaker::choose(const CellFrame& frame) {
  const Index unresolved = task_.rule.tally().unresolved;
  std::optional<Split> split =
      task_.rule.choose({frame.box, frame.depth, lists_.entries(frame.triangles), frame.rule,
                         frame.edges, made_.crossings.all, frame.state[0]});
  if (task_.rule.tally().unresolved > unresolved) made_.unresolved.push_back(centre_of(frame.box));
  if (!split && frame.depth < task_.depth && task_.model.must_split(frame.box)) {
    split = halve_longest(frame.box);
  }
  return split;
}

// Takes what is in a cell over from the former construction, if it would come out the same.
bool CellMaker::take_over(const CellFrame& frame, const SplitNote& now, const FormerCell& former) {
  const FormerCells& before = former_cells();
  const SplitId first = before.cells[former.cell].split();
  const SplitNote& note = before.splits[first];
  if (now.solids != note.solids || now.several_solids != note.several_solids) return false;
  if ((now.solids & task_.memory.moved) != 0) return false;
  if (!same_border(frame, made_.crossings.all, former, before.crossings.all, task_.surface,
                   task_.memory.moved)) {
    return false;
  }
  const std::span<const Vec3> unresolved(before.unresolved.data() + note.unresolved_begin,
                                         note.unresolved_end - note.unresolved_begin);
  if (!task_.rule.has_budget(note.fine_splits) || !budget_.take_splits(note.end - first)) {
    return false;
  }
  task_.rule.count_cells(note.fine_splits, unresolved);
  copy_splits(before, former.cell, frame.cell, made_, *task_.memory.notes);
  return true;
}

SplitId CellMaker::begin_note(SplitNote note) {
  const SplitId number = made_.splits() - 1;
  if (task_.memory.notes == nullptr) return number;
  note.fine_splits = task_.rule.tally().fine_splits;
  note.unresolved_begin = static_cast<Index>(made_.unresolved.size());
  task_.memory.notes->splits.push_back(note);
  return number;
}

void CellMaker::end_note(SplitId number) {
  if (task_.memory.notes == nullptr) return;
  SplitNote& note = task_.memory.notes->splits[number];
  note.end = made_.splits();
  note.fine_splits = task_.rule.tally().fine_splits - note.fine_splits;
  note.unresolved_end = static_cast<Index>(made_.unresolved.size());
}

Halves CellMaker::divide(const CellFrame& frame, const Split& split, CellId first_child) {
  Halves halves{frame, frame};
  cut_edges(
      split, made_.crossings.all,
      [&](bool high_next, bool high_previous, int counted) {
        return task_.model.state_at(
            corner_on_plane(frame.box, split.axis, split.value, high_next, high_previous), counted);
      },
      halves.below, halves.above);
  const TriangleLists::Children lists = lists_.divide(frame.triangles, split.axis, split.value);
  halves.below.triangles = lists.below;
  halves.above.triangles = lists.above;
  add_splitting_edges(frame.box, split, halves);
  const auto ranges = task_.rule.divide(frame.rule, split);
  halves.below.rule = ranges[0];
  halves.above.rule = ranges[1];
  divide_box(frame, split, first_child, halves);
  divide_progress(frame, halves);
  return halves;
}

// Finds and classifies the crossings of the four new edges and hands the edges to both halves.
void CellMaker::add_splitting_edges(const LatticeBox& box, const Split& split, Halves& halves) {
  search_.run(box, split, lists_);
  const int u = next_axis(split.axis);
  const int v = previous_axis(split.axis);
  // The corner of the upper half at the low end of each edge, and at the high end.
  const std::array<int, 4> low_corner{0, 1 << u, 1 << v, 0};
  const std::array<int, 4> high_corner{1 << u, 1 << u | 1 << v, 1 << u | 1 << v, 1 << v};
  for (int i = 0; i < 4; ++i) {
    const int axis = axis_of_edge(split.axis, i);
    EdgeRange range;
    range.begin = static_cast<Index>(made_.crossings.all.size());
    task_.model.plan_edge(
        {axis, corner_on_plane(box, split.axis, split.value, i == 1, i == 2), box.hi[axis],
         halves.above.state[low_corner[i]], halves.above.state[high_corner[i]]},
        search_.on_edge(i), made_.crossings.all);
    range.end = static_cast<Index>(made_.crossings.all.size());
    for (Index c = range.begin; c < range.end; ++c) {
      task_.rule.on_crossing(made_.crossings.all[c].triangle());
    }
    made_.crossings.edge_begin.push_back(range.end);
    hand_down_edge(split.axis, i, range, halves.below.edges, halves.above.edges);
  }
}

}  // namespace kdm
