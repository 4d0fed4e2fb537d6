// SPDX-License-Identifier: MIT
// Separates closed parts from others, and builds the others by themselves.
#include "csg/solidify.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <unordered_set>
#include <utility>

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

// Parts, joined by sides that are opposite to each other.
struct FaceParts {
  std::vector<Index> of;  // per triangle
  Marks open;             // per part: a side has no opposite

  bool open_triangle(TriangleId t) const { return open.test(of[t]); }
};

FaceParts parts_of(const InputFaces& faces) {
  FaceParts parts;
  parts.of = find_parts(faces.topology);
  parts.of.resize(faces.triangles.size(), 0);  // it is empty if there is but one part
  const Index count = 1 + *std::max_element(parts.of.begin(), parts.of.end());
  parts.open.assign(count);
  for (SideId side = 0; side < faces.topology.opposite.size(); ++side) {
    if (faces.topology.opposite[side] == kNone) parts.open.set(parts.of[triangle_of(side)]);
  }
  return parts;
}

// The open parts as a mesh over all points, and the part of each of its triangles.
struct OpenMesh {
  Mesh mesh;
  std::vector<Index> part_of;
};

OpenMesh mesh_of_open(const InputFaces& faces, const FaceParts& parts) {
  OpenMesh open;
  open.mesh.positions = faces.points;
  for (TriangleId t = 0; t < faces.triangles.size(); ++t) {
    if (!parts.open_triangle(t)) continue;
    open.mesh.triangles.push_back(faces.triangles[t]);
    open.mesh.source_faces.push_back(faces.source_faces[t]);
    open.part_of.push_back(parts.of[t]);
  }
  return open;
}

// What was made of the open parts.
struct Built {
  Mesh solid;
  GridStats stats;
  InputReport report;
};

Built build(const Mesh& mesh, const BuildOptions& options, const Progress& progress) {
  const Grid grid = build_grid(mesh, options, progress);
  return {extract(grid), grid.stats(), grid.input()};
}

// Returns an empty solid if they enclose nothing.
Built build_what_encloses(const Mesh& mesh, const BuildOptions& options,
                          const Progress& progress) try {
  Built built = build(mesh, options, progress);
  drop_invented_parts(kMostInvented, built.solid);
  return built;
} catch (const Error& error) {
  if (error.code() != ErrorCode::kNotClosed && error.code() != ErrorCode::kEmptyResult) throw;
  return {};
}

// Marks the parts of which some triangle has a corner that is not inside of the faces, which are
// closed.
Marks find_uncovered(const OpenMesh& open, std::size_t parts, const InputFaces& faces) {
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
void count_parts(const OpenMesh& open, const FaceParts& parts, const InputFaces& faces,
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

// Inserts a closed mesh before the patches, which are the last triangles.
void insert(const Mesh& solid, InputFaces& faces) {
  const auto first = static_cast<Index>(faces.points.size());
  const auto at = static_cast<std::ptrdiff_t>(faces.triangles.size() - faces.patch_planes.size());
  faces.points.insert(faces.points.end(), solid.positions.begin(), solid.positions.end());
  std::vector<Triangle> triangles = solid.triangles;
  for (Triangle& t : triangles) {
    for (Index& corner : t) corner += first;
  }
  std::vector<Index> source_faces = solid.source_faces;
  std::replace(source_faces.begin(), source_faces.end(), kNone, kPatch);
  faces.triangles.insert(faces.triangles.begin() + at, triangles.begin(), triangles.end());
  faces.source_faces.insert(faces.source_faces.begin() + at, source_faces.begin(),
                            source_faces.end());
}

}  // namespace

bool some_part_is_closed(const InputFaces& faces) {
  const FaceParts parts = parts_of(faces);
  return parts.open.count() < parts.open.size();
}

double solidify_open_parts(InputFaces& faces, const BuildOptions& options,
                           const Progress& progress) {
  const FaceParts parts = parts_of(faces);
  const OpenMesh open = mesh_of_open(faces, parts);
  const bool all = open.part_of.size() == faces.triangles.size();
  BuildOptions own = options;
  own.minimum_thickness = own.minimum_gap = 0;
  if (!goes_by_tolerance(options)) own.strategy = SplitStrategy::kAdaptive;
  own.cells = 0;
  own.tolerance = (all ? kShareOfAll : kShareOfSome) * tolerance_of(options, faces.report.extent);
  own.relative_tolerance = BuildOptions().relative_tolerance;  // which does not count
  const Built built =
      all ? build(open.mesh, own, progress) : build_what_encloses(open.mesh, own, progress);
  Marks open_triangles;
  for (TriangleId t = 0; t < faces.triangles.size(); ++t) {
    open_triangles.push_back(parts.open_triangle(t));
  }
  drop_faces(faces, open_triangles);
  insert(built.solid, faces);
  faces.repair = false;
  faces.bounds = bounds_of(faces);
  find_topology(faces);
  tidy_closed_parts(faces);
  InputReport& report = faces.report;
  count_parts(open, parts, faces, report);
  report.sewn_edges += built.report.sewn_edges;
  report.sewing_distance = std::max(report.sewing_distance, built.report.sewing_distance);
  report.patched_holes += built.report.patched_holes;
  report.patch_area += built.report.patch_area;
  report.rebuilding_tolerance = report.rebuilt_parts > 0 ? built.stats.tolerance : 0;
  return report.rebuilt_parts > 0 ? built.stats.winding_threshold : 0;
}

}  // namespace kdm
