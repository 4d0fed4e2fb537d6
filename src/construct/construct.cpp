// SPDX-License-Identifier: MIT
// The top-down construction of the cell tree and its hits (paper 5.1.1): attempts to make the
// cells, and the hits that follow from them.
#include "construct/construct.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "construct/bottom_up.h"
#include "construct/cell_maker.h"
#include "construct/cells_in_parts.h"
#include "threads/share_work.h"

namespace kdm {
namespace {

// What every attempt to construct the cells has in common.
struct Construction {
  const Surface& surface;
  const BuildOptions& options;
  int depth;
  InsideModel& model;
  const Progress& progress;
};

// Makes the cells. Returns the fraction of them that was made before the budget was exceeded; 1 if
// all were.
double make_cells(const Construction& construction, double tolerance, const CellMemory& memory,
                  GridStats& stats, MadeCells& made) {
  const auto& [surface, options, depth, model, progress] = construction;
  const MakeRule make_rule = [&](InsideModel& asked) {
    return make_split_rule(construction.surface, asked, construction.options, tolerance,
                           construction.depth);
  };
  const std::unique_ptr<SplitRule> rule = make_rule(model);
  const CellTask task{surface, depth, model, *rule, memory, progress};
  const Budget budget = surface.repair || surface.patched
                            ? Budget::for_repair(surface.triangles.size(), model.work())
                            : Budget();
  if (memory.notes != nullptr) *memory.notes = {};
  std::optional<MadeCells> shared;
  if constexpr (kHasThreads) {
    if (may_be_shared(task)) shared = make_cells_in_parts(task, budget, make_rule);
  }
  if (shared) {
    made = std::move(*shared);
  } else {
    CellMaker maker(task, budget);
    maker.make_all();
    if (!maker.budget().sufficed()) return maker.budget().done();
    made = std::move(maker.made());
  }
  if (memory.notes != nullptr) memory.notes->complete = rule->is_local();
  stats = {};
  rule->report(stats);
  model.report(stats);
  return 1;
}

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
  if (memory.notes == nullptr && suits_bottom_up(surface, model, options, depth)) {
    ConstructedCells made{tolerance, {}, nullptr};
    made.finest = construct_bottom_up(surface, model, depth, progress, grid, made.triangle_of_hit);
    return made;
  }
  for (;;) {
    MadeCells made;
    const double done =
        make_cells({surface, options, depth, model, onwards}, tolerance, memory, grid.stats, made);
    if (done == 1) {
      made.cells.shrink_to_fit();
      if (memory.notes == nullptr) {
        grid.cells = std::move(made.cells);
      } else {
        grid.cells = made.cells;
      }
      ConstructedCells constructed{tolerance, make_hits(made.crossings, surface, model, grid),
                                   nullptr};
      if (memory.notes != nullptr) static_cast<MadeCells&>(*memory.notes) = std::move(made);
      return constructed;
    }
    tolerance = widening_for(done) * std::max(tolerance, 1.0);
    memory = {};
  }
}

std::vector<TriangleId> construct_cells_by(SplitRule& rule, const Surface& surface,
                                           InsideModel& model, const Progress& progress,
                                           GridData& grid) {
  const CellMemory memory;
  CellMaker maker({surface, kMaxDepth, model, rule, memory, progress}, Budget());
  maker.make_all();
  grid.cells = std::move(maker.made().cells);
  grid.stats = {};
  rule.report(grid.stats);
  model.report(grid.stats);
  return make_hits(maker.made().crossings, surface, model, grid);
}

}  // namespace kdm
