// SPDX-License-Identifier: MIT
// The recursion over cells (paper 5.1.1).
//
// A cell hands down its twelve edges, each a range of crossings on one ancestor's splitting edge,
// and the inside model's states at its corners. So the state at a new corner is looked up in a
// range of crossings, never searched for among triangles.
#pragma once

#include <optional>
#include <vector>

#include "construct/budget.h"
#include "construct/cell_frame.h"
#include "construct/cell_progress.h"
#include "construct/crossing_search.h"
#include "construct/former_cells.h"
#include "construct/made_cells.h"
#include "construct/solid_filter.h"
#include "grid/grid_data.h"
#include "inside/inside_model.h"
#include "prepare/surface.h"
#include "split/split_rules.h"
#include "split/triangle_lists.h"

namespace kdm {

/// A cell that is left for later, with all that it takes to go on there.
struct Subtree {
  CellFrame frame;                         ///< as it was
  std::vector<ListEntry> entries;          ///< of its list
  std::vector<ClassifiedCrossing> border;  ///< of its edges, one after the other
  SplitId splits_before = 0;               ///< how many splits were made when it was left
  Index unresolved_before = 0;             ///< how many leaves were unresolved then
};

/// What one construction is about. Everything must outlive the makers that are given it.
struct CellTask {
  const Surface& surface;
  int depth;  ///< that no cell goes beyond
  InsideModel& model;
  SplitRule& rule;
  const CellMemory& memory;
  const Progress& progress;
};

/// Makes the cells of a grid or of a part of it, in depth-first order, lower halves first.
class CellMaker {
 public:
  CellMaker(const CellTask& task, const Budget& budget);
  /// Makes the cells within one that was left. In what is made, it is cell 0; the first crossings
  /// are those of its border.
  CellMaker(const CellTask& task, const Budget& budget, const Subtree& subtree);

  /// Makes all cells. Stops where the budget is exceeded.
  void make_all();
  /// Makes the upper cells, and leaves those with at most so many triangles for later.
  std::vector<Subtree> make_top(Index most_triangles);

  const Budget& budget() const { return budget_; }
  MadeCells& made() { return made_; }

 private:
  CellMaker(const CellTask& task, const Budget& budget, TriangleLists lists);

  void split_cell(CellFrame& frame, const FormerCell* former);
  void leave(const CellFrame& frame);
  std::optional<Split> choose(const CellFrame& frame);
  const FormerCells& former_cells() const { return *task_.memory.former; }
  bool take_over(const CellFrame& frame, const SplitNote& now, const FormerCell& former);
  SplitId begin_note(SplitNote note);
  void end_note(SplitId number);
  Halves divide(const CellFrame& frame, const Split& split, CellId first_child);
  void add_splitting_edges(const LatticeBox& box, const Split& split, Halves& halves);

  CellTask task_;
  Budget budget_;
  TriangleLists lists_;
  CrossingSearch search_;
  SolidFilter solids_;
  CellProgress progress_;
  CellFrame root_;
  MadeCells made_;
  Index most_left_ = 0;  // triangles of cells that are left for later
  std::vector<Subtree> left_;
};

}  // namespace kdm
