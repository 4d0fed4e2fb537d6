// SPDX-License-Identifier: MIT
// Builds group after group.
#include "csg/unite_thin.h"

#include <algorithm>
#include <utility>

#include "construct/body_search.h"
#include "csg/grid_of_faces.h"
#include "csg/open_and_close.h"
#include "csg/open_parts.h"
#include "csg/thin_groups.h"
#include "kdmanifold/error.h"
#include "kdmanifold/extract.h"
#include "mesh/progress.h"
#include "prepare/edit_faces.h"
#include "prepare/input_faces.h"

namespace kdm {
namespace {

// What a group is built within, as a share of its thickness.
constexpr double kShareOfThickness = 0.125;

// Builds the union of a group's parts. Returns nothing if nothing comes out, if its triangles
// cross, or if it is not thin by `tolerance`, so that it would not be taken over as it is.
Mesh build_union(const ThinGroup& group, const BuildOptions& options, double tolerance,
                 const Progress& progress) try {
  BuildOptions own;
  own.inside = InsideRule::kPositive;
  own.pairing = options.pairing;
  own.tolerance = kShareOfThickness * group.thickness;
  const Grid grid = grid_of_faces(prepare_faces(group.mesh, own), own, 1, 0, progress);
  ExtractedMesh united = extract(grid);
  const MeshReport report = describe(united);
  const bool exact =
      united.report.crossings == 0 && is_thin(report.volume, report.area, report.bounds, tolerance);
  return exact ? std::move(united) : Mesh();
} catch (const Error& error) {
  if (error.code() != ErrorCode::kEmptyResult) throw;
  return {};
}

}  // namespace

void unite_thin_parts(InputFaces& faces, const BuildOptions& options, const Progress& progress) {
  const InsideRule rule = options.inside;
  const bool adds_up = rule == InsideRule::kPositive || rule == InsideRule::kRepair;
  const bool may_split = goes_by_tolerance(options) && options.depth == 0;
  if (faces.repair || !adds_up || !may_split || opens_or_closes(options)) return;
  const double tolerance = tolerance_of(options, faces.report.extent);
  const ThinGroups thin = find_thin_groups(faces, tolerance);
  // Where a part that is inside out takes 1 away, only what two parts hold is inside.
  if (rule == InsideRule::kPositive && thin.some_inside_out) return;
  std::vector<Mesh> unions;
  const auto count = static_cast<double>(thin.groups.size());
  for (const ThinGroup& group : thin.groups) {
    const auto done = static_cast<double>(unions.size());
    unions.push_back(build_union(group, options, tolerance,
                                 part_of_progress(progress, done / count, (done + 1) / count)));
    if (unions.back().triangles.empty()) continue;
    faces.report.rebuilt_parts += group.parts;
    faces.report.rebuilding_tolerance =
        std::max(faces.report.rebuilding_tolerance, kShareOfThickness * group.thickness);
  }
  Marks goes(faces.triangles.size());
  for (TriangleId t = 0; t < thin.part_of.size(); ++t) {
    const Index group = thin.group_of[thin.part_of[t]];
    if (group != kNone) goes.set(t, !unions[group].triangles.empty());
  }
  if (!goes.any()) return;
  drop_faces(faces, goes);
  for (const Mesh& united : unions) insert_closed(united, faces);
  faces.bounds = bounds_of(faces);
  find_topology(faces);
}

}  // namespace kdm
