// SPDX-License-Identifier: MIT
// Separates closed parts from others, and builds the others by themselves.
#include "csg/solidify.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <unordered_set>
#include <utility>

#include "csg/grid_of_faces.h"
#include "csg/open_parts.h"
#include "csg/rough_look.h"
#include "extract/keep_parts.h"
#include "geometry/lattice.h"
#include "inside/winding_field.h"
#include "kdmanifold/build.h"
#include "kdmanifold/error.h"
#include "kdmanifold/extract.h"
#include "mesh/measure.h"
#include "prepare/edit_faces.h"
#include "prepare/input_faces.h"

namespace kdm {
namespace {

// What open parts are built within, as a fraction of the tolerance. Beside closed parts, which stay
// as they are, half of it would take twice the time for what winding numbers only guess at.
constexpr double kShareOfAll = 0.5;
constexpr double kShareOfSome = 1;

// What is made of open parts is left out where more than this many times the area that comes from
// their faces is new: it is what winding numbers see behind sheets that hardly bend, or cross.
constexpr double kMostInvented = 0.5;

// A rough look at the open parts tells what is left out for sure.
constexpr double kSurelyInvented = 0.75;

// What was made of the open parts.
struct Built {
  Mesh solid;
  GridStats stats;
};

Built build(InputFaces faces, const BuildOptions& options, const Progress& progress) {
  if (faces.triangles.empty()) return {};
  const Grid grid = grid_of_faces(std::move(faces), options, 1, 0, progress);
  return {extract(grid), grid.stats()};
}

// Calls a function; what it makes is empty if it finds that the faces enclose nothing.
template <typename Make>
auto or_nothing(const Make& make) -> decltype(make()) {
  try {
    return make();
  } catch (const Error& error) {
    if (error.code() != ErrorCode::kNotClosed && error.code() != ErrorCode::kEmptyResult) throw;
    return {};
  }
}

// Drops the parts of which a rough look says that all that is made of their faces is mostly
// invented. Where it sees nothing that is enclosed, it says nothing: within the tolerance there may
// be something.
void drop_what_encloses_nothing(InputFaces& faces, const BuildOptions& options,
                                const Progress& progress) {
  if (faces.triangles.empty()) return;
  Mesh solid = or_nothing([&] { return look_roughly(faces, options, progress); });
  const std::unordered_set<Index> made(solid.source_faces.begin(), solid.source_faces.end());
  drop_invented_parts(kSurelyInvented, solid);
  const std::unordered_set<Index> kept(solid.source_faces.begin(), solid.source_faces.end());
  const FaceParts parts = parts_of(faces);
  Marks goes(parts.open.size());
  for (TriangleId t = 0; t < faces.triangles.size(); ++t) {
    if (made.contains(faces.source_faces[t])) goes.set(parts.of[t]);
  }
  for (TriangleId t = 0; t < faces.triangles.size(); ++t) {
    if (kept.contains(faces.source_faces[t])) goes.clear(parts.of[t]);
  }
  Marks dropped;
  for (const Index part : parts.of) dropped.push_back(goes.test(part));
  drop_faces(faces, dropped);
  find_topology(faces);
}

// Marks the parts of which some triangle has a corner that is not inside of the faces, which are
// closed.
Marks find_uncovered(const PartsMesh& open, std::size_t parts, const InputFaces& faces) {
  const Lattice lattice = lattice_over(faces.bounds);
  std::vector<LatticeTriangle> triangles;
  triangles.reserve(faces.triangles.size());
  for (const auto& [a, b, c] : faces.triangles) {
    triangles.push_back({lattice.quantise(faces.points[a]), lattice.quantise(faces.points[b]),
                         lattice.quantise(faces.points[c])});
  }
  constexpr double kInside = 0.5;
  constexpr double kSpacing = kLatticeSize / 256;
  const WindingField field(triangles, kInside, kSpacing);
  Marks uncovered(parts);
  for (std::size_t t = 0; t < open.part_of.size(); ++t) {
    if (uncovered.test(open.part_of[t])) continue;
    for (const Index corner : open.mesh.triangles[t]) {
      const Vec3& p = open.mesh.positions[corner];
      const bool within = (p.array() >= faces.bounds.min.array()).all() &&
                          (p.array() <= faces.bounds.max.array()).all();
      if (!within || !field.inside(lattice.to_lattice(p))) uncovered.set(open.part_of[t]);
    }
  }
  return uncovered;
}

// Counts the open parts that were built, and those that are lost: nothing is left of their faces,
// and they do not lie inside of others either.
void count_parts(const PartsMesh& open, const FaceParts& parts, const InputFaces& faces,
                 InputReport& report) {
  const std::unordered_set<Index> left(faces.source_faces.begin(), faces.source_faces.end());
  Marks built(parts.open.size());
  for (std::size_t t = 0; t < open.part_of.size(); ++t) {
    if (left.contains(open.mesh.source_faces[t])) built.set(open.part_of[t]);
  }
  const auto count = static_cast<Index>(built.count());
  report.rebuilt_parts = count;
  if (count == parts.open.count()) return;
  const Marks uncovered = find_uncovered(open, parts.open.size(), faces);
  std::vector<Measure> measures(parts.open.size());
  for (std::size_t t = 0; t < open.part_of.size(); ++t) {
    const auto& [a, b, c] = open.mesh.triangles[t];
    const std::vector<Vec3>& points = open.mesh.positions;
    measures[open.part_of[t]].add(points[a], points[b], points[c]);
  }
  for (Index part = 0; part < parts.open.size(); ++part) {
    if (!parts.open.test(part) || built.test(part) || !uncovered.test(part)) continue;
    ++report.lost_parts;
    report.lost_area += measures[part].area;
    report.largest_lost = std::max(report.largest_lost, measures[part].area);
  }
}

}  // namespace

bool some_part_is_closed(const InputFaces& faces) { return parts_of(faces).some_closed(); }

double solidify_open_parts(InputFaces& faces, const BuildOptions& options,
                           const Progress& progress) {
  const FaceParts parts = parts_of(faces);
  const PartsMesh open = mesh_of_parts(faces, parts, true);
  const bool all = !parts.some_closed();
  BuildOptions own = options;
  own.minimum_thickness = own.minimum_gap = 0;
  if (!goes_by_tolerance(options)) own.strategy = SplitStrategy::kAdaptive;
  own.cells = 0;
  own.tolerance = (all ? kShareOfAll : kShareOfSome) * tolerance_of(options, faces.report.extent);
  own.relative_tolerance = BuildOptions().relative_tolerance;  // which does not count
  const auto prepare = [&] { return prepare_by_themselves(open.mesh, own); };
  OpenParts rest = all ? prepare() : or_nothing(prepare);
  const auto build_rest = [&] {
    if (!all) drop_what_encloses_nothing(rest.faces, own, progress);
    return build(std::move(rest.faces), own, progress);
  };
  Built built = all ? build_rest() : or_nothing(build_rest);
  if (!all) drop_invented_parts(kMostInvented, built.solid);
  Marks open_triangles;
  for (TriangleId t = 0; t < faces.triangles.size(); ++t) {
    open_triangles.push_back(parts.open_triangle(t));
  }
  drop_faces(faces, open_triangles);
  insert_closed(rest.closed, faces);
  insert_closed(built.solid, faces);
  faces.repair = false;
  faces.bounds = bounds_of(faces);
  find_topology(faces);
  tidy_closed_parts(faces);
  InputReport& report = faces.report;
  count_parts(open, parts, faces, report);
  add_repairs(rest.done, report);
  report.rebuilding_tolerance = report.rebuilt_parts > 0 ? built.stats.tolerance : 0;
  return report.rebuilt_parts > 0 ? built.stats.winding_threshold : 0;
}

}  // namespace kdm
