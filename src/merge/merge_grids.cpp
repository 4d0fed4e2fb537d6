// SPDX-License-Identifier: MIT
// Merges two grids: the steps in their order.
#include <algorithm>
#include <new>
#include <utility>

#include "construct/construct.h"
#include "grid/count_stats.h"
#include "kdmanifold/error.h"
#include "kdmanifold/merge.h"
#include "link/link.h"
#include "merge/kept_hits.h"
#include "merge/merge_exact.h"
#include "merge/merge_model.h"
#include "merge/merge_rule.h"
#include "mesh/progress.h"
#include "prepare/joined_solids.h"
#include "text/compose.h"

namespace kdm {
namespace {

void check_grids(const GridData& first, const GridData& second) {
  if (first.sheet || second.sheet) {
    throw Error(ErrorCode::kInvalidOption,
                compose("the {} grid is that of a sheet, which bounds no solid",
                        first.sheet ? "first" : "second"));
  }
  if (first.lattice != second.lattice) {
    throw Error(ErrorCode::kInvalidOption,
                "the grids have different lattices; build both with the same `box`, one that holds "
                "both models");
  }
}

// Returns the plane of a triangle that a hit spans: that of the hit where the triangle lies in it
// but for rounding, or is so thin that rounding turns it, else its own.
Plane plane_of(const LatticeTriangle& triangle, const Plane& of_hit) {
  constexpr double kRounding = 2;  // lattice units
  constexpr double kThin = 64;
  double off = 0;
  for (const LatticePoint& p : triangle) off = std::max(off, of_hit.distance(to_vec3(p)));
  const auto area = area_vector(triangle);
  const Vec3 normal(static_cast<double>(area[0]), static_cast<double>(area[1]),
                    static_cast<double>(area[2]));
  const double length = normal.norm();
  double longest = 0;
  for (int i = 0; i < 3; ++i) {
    longest = std::max(longest, (to_vec3(triangle[i]) - to_vec3(triangle[(i + 1) % 3])).norm());
  }
  if (off <= kRounding || length <= kThin * longest) return of_hit;
  return {normal / length, (normal / length).dot(to_vec3(triangle[0]))};
}

// Joins the spanned surfaces of both solids, as a surface of two operands.
Surface join_surfaces(const std::array<const GridSolid*, 2>& solids) {
  Surface all;
  all.lattice = solids[0]->grid().lattice;
  all.operand_of_solid = {0, 1};
  for (Index i = 0; i < 2; ++i) {
    const GridData& grid = solids[i]->grid();
    const SpannedSurface& spanned = solids[i]->surface();
    const auto first = static_cast<PointId>(all.points.size());
    all.extent = std::max(all.extent, grid.input.extent);
    for (const LatticePoint& p : spanned.points) {
      all.points.push_back(all.lattice.to_model(to_vec3(p)));
    }
    for (Index t = 0; t < spanned.corners.size(); ++t) {
      const auto& [a, b, c] = spanned.corners[t];
      const LatticeTriangle triangle = solids[i]->triangle(t);
      const auto area = area_vector(triangle);
      const PlaneId plane = grid.hits[spanned.hit[t]].plane();
      all.triangles.push_back(triangle);
      all.corners.push_back({first + a, first + b, first + c});
      all.planes.push_back(plane_of(triangle, grid.planes[plane]));
      all.source_faces.push_back(grid.source_faces[plane]);
      all.degenerate.push_back(area[0] == 0 && area[1] == 0 && area[2] == 0);
      all.solid_of.push_back(i);
    }
  }
  all.topology = build_topology(all.corners, static_cast<Index>(all.points.size()));
  all.part_of = find_parts(all.topology);
  return all;
}

std::vector<InputReport> operands_of(const GridData& grid) {
  return grid.operands.empty() ? std::vector<InputReport>{grid.input} : grid.operands;
}

// Sets what is reported of the merged grid, whose `stats` have the account of the rule. `fits` says
// whether the signs of both grids agreed with their surfaces everywhere.
void report(const GridData& first, const GridData& second, bool fits, GridData& merged) {
  merged.operands = operands_of(first);
  const std::vector<InputReport> others = operands_of(second);
  merged.operands.insert(merged.operands.end(), others.begin(), others.end());
  merged.input = sum_of(merged.operands);
  merged.input.extent = std::max(first.input.extent, second.input.extent);
  merged.input.lattice_step = merged.lattice.step;
  GridStats& stats = merged.stats;
  for (Vec3& p : stats.unresolved_positions) p = merged.lattice.to_model(p);
  bool resolved = stats.topology_resolved && fits && stats.guessed_faces == 0;
  for (const GridData* grid : {&first, &second}) {
    const GridStats& own = grid->stats;
    resolved = resolved && own.topology_resolved;
    stats.asked_tolerance = std::max(stats.asked_tolerance, own.asked_tolerance);
    stats.winding_threshold = std::max(stats.winding_threshold, own.winding_threshold);
    stats.unresolved_leaves += own.unresolved_leaves;
    stats.guessed_faces += own.guessed_faces;
    stats.thin_parts += own.thin_parts;
    stats.unresolved_positions.insert(stats.unresolved_positions.end(),
                                      own.unresolved_positions.begin(),
                                      own.unresolved_positions.end());
  }
  stats.topology_resolved = resolved;
  const std::vector<Index> parts = find_parts(
      build_topology(merged.exact.triangles, static_cast<Index>(merged.exact.positions.size())));
  stats.exact_parts = merged.exact.triangles.empty() ? 0
                      : parts.empty()                ? 1
                                      : 1 + *std::max_element(parts.begin(), parts.end());
  count_stats(merged);
}

}  // namespace

Grid merge_grids(const Grid& first, const Grid& second, const Expression& expression,
                 const Progress& progress) try {
  const MergeFunction function(expression);
  const GridData& a = first.data();
  const GridData& b = second.data();
  check_grids(a, b);
  report_progress(progress, 0.0, "prepare");
  const GridSolid solid_a(a);
  report_progress(progress, 0.05, "prepare");
  const GridSolid solid_b(b);
  const std::array<const GridSolid*, 2> solids{&solid_a, &solid_b};
  auto merged = std::make_unique<GridData>();
  const auto operands = static_cast<Index>(operands_of(a).size());
  merged->exact = merge_exact(solids, function, {0, operands});
  const Surface surface = join_surfaces(solids);
  merged->lattice = a.lattice;
  merged->tolerance = std::max(a.tolerance, b.tolerance);
  merged->inside = a.inside == b.inside ? a.inside : InsideRule::kRepair;
  merged->thickness = std::max(a.thickness, b.thickness);
  merged->simplified = std::max(a.simplified, b.simplified);
  report_progress(progress, 0.1, "build");
  MergeModel model(solid_a, solid_b, function, surface, merged->tolerance);
  MergeRule rule(
      solid_a, solid_b, function, merged->tolerance,
      make_adaptive_rule(surface, model, merged->tolerance, kMaxDepth, CutPosition::kHalving));
  const std::vector<TriangleId> triangle_of_hit =
      construct_cells_by(rule, surface, model, part_of_progress(progress, 0.1, 0.8), *merged);
  if (merged->hits.empty() && merged->exact.triangles.empty()) {
    throw Error(ErrorCode::kEmptyResult, "the merge leaves nothing of the two grids");
  }
  report_progress(progress, 0.8, "link");
  link_half_edges(surface, triangle_of_hit, Pairing::kTrace, *merged);
  const std::vector<HitOrigin> origins = find_origins(solids, surface, triangle_of_hit, *merged);
  take_planes(solids, surface, triangle_of_hit, origins, *merged);
  take_links(solids, origins, *merged);
  report(a, b, model.fitted() == 0, *merged);
  report_progress(progress, 1.0, "link");
  return Grid(std::move(merged));
} catch (const std::bad_alloc&) {
  throw Error(ErrorCode::kOutOfMemory, "there is not enough memory to merge the grids");
}

}  // namespace kdm
