// SPDX-License-Identifier: MIT
#include "construct/bottom_up.h"

#include <utility>

#include "construct/finest_marking.h"
#include "construct/line_plan.h"
#include "inside/hit_writer.h"
#include "mesh/progress.h"

namespace kdm {
namespace {

// The part of the work that it takes to divide the triangles.
constexpr double kDivided = 0.7;

void write_planned_hits(const LinePlan& plan, const FinestTree& tree, HitWriter& writer) {
  const SplitId splits = writer.grid().splits();
  std::vector<Index> plan_of(4 * std::size_t{splits}, kNone);  // per splitting edge
  for (Index i = 0; i < plan.edges.size(); ++i) {
    plan_of[plan.edges[i].below] = i;
    plan_of[plan.edges[i].above] = i;
  }
  for (SplitId split = 0; split < splits; ++split) {
    for (int i = 0; i < 4; ++i) {
      const EdgePlace edge{edge_of_split(split, i), i, axis_of_edge(tree.axis(split), i)};
      const Index twins = plan_of[edge.number];
      if (twins != kNone) {
        for (Index c = plan.begin[twins]; c < plan.begin[twins + 1]; ++c) {
          writer.add(edge, plan.crossings[c]);
        }
      }
      writer.end_edge(edge);
    }
  }
}

}  // namespace

bool suits_bottom_up(const Surface& surface, const InsideModel& model, const BuildOptions& options,
                     int depth) {
  return options.strategy == SplitStrategy::kUniform && depth <= FinestCells::kMostDepth &&
         model.only_counts() && !surface.patched && !surface.several_solids() &&
         !surface.triangles.empty();
}

std::unique_ptr<FinestGrid> construct_bottom_up(const Surface& surface, InsideModel& model,
                                                int depth, const Progress& progress, GridData& grid,
                                                std::vector<TriangleId>& triangle_of_hit) {
  constexpr TriangleId kInterval = 4096;  // triangles between two calls
  const auto triangles = static_cast<TriangleId>(surface.triangles.size());
  grid.stats = {};
  FinestCells cells(depth);
  std::vector<LineCrossing> crossings;
  FinestMarking marking(surface.triangles, cells, crossings);
  for (TriangleId t = 0; t < triangles; ++t) {
    if (t % kInterval == 0) report_progress(progress, kDivided * t / triangles, "build");
    marking.add(t);
  }
  auto finest = std::make_unique<FinestGrid>(
      FinestGrid{FinestTree(std::move(cells), marking.take_empty_splits(), grid), {}});
  LinePlan plan =
      plan_lines(crossings, finest->tree, model, part_of_progress(progress, kDivided, 1));
  model.report(grid.stats);
  HitWriter writer(surface, 2 * plan.crossings.size(), grid);
  write_planned_hits(plan, finest->tree, writer);
  mark_active_sides(grid);
  triangle_of_hit = writer.finish();
  finest->edges = std::move(plan.edges);
  return finest;
}

}  // namespace kdm
